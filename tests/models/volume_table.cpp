#include "tests/models/volume_table.hpp"

#include <fstream>
#include <sstream>

#include "tests/models/corpus.hpp"

namespace cardioid::test {

namespace fs = std::filesystem;

fs::path VolumeRow::program() const {
    // Folders and file are joined by "__".
    const std::string path = fs::path(name).replace_extension(".scad").string();
    fs::path program = openscad_share;
    std::size_t begin = 0;
    for (std::size_t end; (end = path.find("__", begin)) != std::string::npos; begin = end + 2)
        program /= path.substr(begin, end - begin);
    return program / path.substr(begin);
}

std::vector<VolumeRow> read_volume_table() {
    std::vector<VolumeRow> rows;
    std::ifstream file(fs::path(CARDIOID_SOURCE_DIR) / "../shared/data/openscad/volumes.tsv");
    std::string line;
    for (std::getline(file, line); std::getline(file, line);) {
        std::vector<std::string> cells;
        std::istringstream in(line);
        for (std::string cell; std::getline(in, cell, '\t');) cells.push_back(cell);
        if (cells.size() < 2) continue;
        VolumeRow row{cells[0], {}, cells.size() > 7 ? cells[7] : ""};
        if (cells[1] != "-") row.volume = std::stod(cells[1]);
        rows.push_back(row);
    }
    return rows;
}

}  // namespace cardioid::test

/// Writes every model of the comparison as a scene of ours and as one of POV-Ray: cardioid_models FOLDER.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "bench/model_files.hpp"

#include "rt_core/api/error.hpp"

namespace {

void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    if (!file.flush()) throw cardioid::Error(cardioid::ErrorCode::io, "cannot write " + path.string());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: cardioid_models FOLDER\n", stderr);
        return 2;
    }
    try {
        const std::filesystem::path folder = argv[1];
        std::filesystem::create_directories(folder);
        for (const cardioid::bench::Model& model : cardioid::bench::all_models()) {
            write(folder / (model.name + ".csg"), as_csg(model));
            write(folder / (model.name + ".pov"), as_pov(model));
            std::printf("%s\n", model.name.c_str());
        }
    } catch (const std::exception& e) {
        std::fprintf(stderr, "cardioid_models: %s\n", e.what());
        return 4;
    }
    return 0;
}

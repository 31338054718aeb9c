#include "formats/openscad/library_path.hpp"

#include <cstdlib>
#include <filesystem>

namespace cardioid::formats::openscad {

namespace fs = std::filesystem;

std::string library_folder() {
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    for (fs::path folder = program.parent_path(); !failed && !folder.empty(); folder = folder.parent_path()) {
        for (const char* const share : {"share/cardioid", "share"}) {
            std::error_code ignored;
            if (fs::is_regular_file(folder / share / "cardioid.scad", ignored)) return (folder / share).string();
        }
        if (folder == folder.root_path()) break;
    }
    return {};
}

std::string library_search_path() {
    const char* const given = std::getenv("OPENSCADPATH");
    std::string path = given ? given : "";
    const std::string ours = library_folder();
    if (!path.empty() && !ours.empty()) path += ':';
    return path + ours;
}

}  // namespace cardioid::formats::openscad

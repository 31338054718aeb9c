#include "cli/version.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <string_view>
#include <unistd.h>

#include "rt_core/api/plugin.h"

namespace cardioid::cli {
namespace {

bool is_on_path(std::string_view program) {
    const char* const variable = std::getenv("PATH");
    const std::string folders = variable ? variable : "";
    for (std::size_t begin = 0; begin < folders.size();) {
        const std::size_t end = std::min(folders.find(':', begin), folders.size());
        if (access(fmt::format("{}/{}", folders.substr(begin, end - begin), program).c_str(), X_OK) == 0) return true;
        begin = end + 1;
    }
    return false;
}

}  // namespace

std::string version() { return CARDIOID_VERSION; }

std::string version_text() {
    return fmt::format(
        "cardioid {}\n"
        "plug-in ABI {}.{}\n"
        "Embree {}, OpenImageIO {}, CGAL {}\n"
        "openscad (for .scad files): {}\n",
        version(), CARDIOID_ABI_MAJOR, CARDIOID_ABI_MINOR, CARDIOID_EMBREE_VERSION, CARDIOID_OPENIMAGEIO_VERSION,
        CARDIOID_CGAL_VERSION, is_on_path("openscad") ? "found" : "not found");
}

}  // namespace cardioid::cli

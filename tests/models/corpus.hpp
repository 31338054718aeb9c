#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rt_core/scene/scene.hpp"
#include "tests/text_file.hpp"

namespace cardioid::test {

/// Where Debian's packages `openscad` and `openscad-testing-data` put their files.
inline const std::filesystem::path openscad_share = "/usr/share/openscad";

/// Whether the program openscad is installed.
bool has_openscad();

/// Whether every model is to be tested, not the quick ones alone: CARDIOID_LONG_TESTS is set, and not to 0.
bool long_tests();

/// All `.scad` files below a folder of `openscad_share`, sorted.
std::vector<std::filesystem::path> programs_below(const std::string& folder);

/// What openscad makes of a program, as a file with this extension (".csg", ".stl"). Kept in the build folder under a
/// hash of the program's path and content, so that the next run finds it. Nothing where openscad refuses the program,
/// has nothing to say, or takes longer than a minute.
std::optional<std::filesystem::path> evaluated(const std::filesystem::path& program, const std::string& extension);

/// The evaluated program with OpenSCAD's facets, by the reader in the program's registry. Throws Error.
Scene read_evaluated(const std::filesystem::path& csg, const std::filesystem::path& program);

/// What an evaluated program needs that this version does not draw: "hull", "text", "import of dxf", ... without
/// repeats. Found by a scan of its own, so that the reader's word is not taken for it.
std::vector<std::string> nodes_to_come(const std::string& csg);

}  // namespace cardioid::test

#pragma once
#include <string>
#include <vector>

namespace cardioid::formats::openscad {

/// What the program openscad made of a file.
struct Evaluated {
    std::string csg;
    std::vector<std::string> warnings;
};

/// Evaluates a `.scad` file with `openscad -o`, without a shell, in a temporary folder that is removed again. `file` is
/// its path; where there is none (standard input), `text` is written to the temporary folder and evaluated there.
/// Throws Error(io) where openscad is missing or its output cannot be read, Error(bad_input) with OpenSCAD's own
/// message where it refuses the file.
Evaluated run_openscad(const std::string& text, const std::string& file);

}  // namespace cardioid::formats::openscad

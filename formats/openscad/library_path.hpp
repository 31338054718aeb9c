#pragma once
#include <string>

namespace cardioid::formats::openscad {

/// The folder of cardioid.scad: share/cardioid beside the bin folder of the program, or share in the source tree that
/// the program was built in; "" where there is neither.
std::string library_folder();

/// What OPENSCADPATH must be for OpenSCAD to find cardioid.scad: the user's own folders first.
std::string library_search_path();

}  // namespace cardioid::formats::openscad

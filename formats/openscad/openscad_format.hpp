#pragma once
#include "rt_core/api/format.hpp"

namespace cardioid::formats {

/// OpenSCAD's evaluated language with our calls: the native scene file, `.csg`.
extern const Format csg_format;

/// OpenSCAD programs, `.scad`: evaluated by the program openscad, which must be installed, then read as `.csg`.
extern const Format scad_format;

}  // namespace cardioid::formats

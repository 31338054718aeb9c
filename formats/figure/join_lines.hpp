#pragma once
#include <vector>

#include "rt_core/math/vec.hpp"

namespace cardioid::formats {

struct Line {
    Vec2d a, b;
};

/// Joins lines whose ends meet (within 2^-20, OpenSCAD's grid) into contours of at least three corners; what stays open
/// is closed by a line. Open chains first, in the order of the lines; lines without a length are left out.
std::vector<std::vector<Vec2d>> join_lines(const std::vector<Line>& lines);

}  // namespace cardioid::formats

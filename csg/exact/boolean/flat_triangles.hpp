#pragma once
#include "csg/exact/boolean/exact_data.hpp"

namespace cardioid::csg {

/// Gets rid of triangles without area, whose neighbours keep meeting: across the longest edge of one the diagonal of
/// the two triangles is exchanged, which splits that edge in the neighbour. Some may stay where more than two meet.
void turn_flat_triangles(const std::vector<ExactPoint>& points, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace cardioid::csg

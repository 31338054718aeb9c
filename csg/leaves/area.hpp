#pragma once
#include "csg/leaves/leaf.hpp"

namespace cardioid::csg {

/// Area of a leaf's surface where there is a formula for it: balls, boxes of any shape, round cones and tori; else 0.
/// Exact but for what six digits leave of the right angles of a placement.
[[nodiscard]] double leaf_area(const SolvedLeaf& leaf) noexcept;

}  // namespace cardioid::csg

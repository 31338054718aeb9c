#pragma once
#include <optional>
#include <span>

#include "csg/exact/boolean/exact_solid.hpp"
#include "rt_core/scene/solid_op.hpp"

namespace cardioid::csg {

/// The boolean of parts whose surfaces do not run through themselves, by CGAL's corefinement with exact numbers;
/// nothing where that cannot make a manifold of the result.
std::optional<ExactSolid> corefine(SolidOp op, std::span<const ExactSolid> parts);

}  // namespace cardioid::csg

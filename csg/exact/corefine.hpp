#pragma once
#include <optional>

#include "rt_core/scene/solid_op.hpp"
#include "rt_core/scene/triangle_mesh.hpp"

namespace cardioid::csg {

/// The boolean of parts whose surfaces do not run through themselves, by CGAL's corefinement with exact numbers;
/// nothing where that cannot make a manifold of the result.
std::optional<TriangleMesh> corefine(SolidOp op, const std::vector<TriangleMesh>& parts);

}  // namespace cardioid::csg

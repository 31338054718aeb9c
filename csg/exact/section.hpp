#pragma once
#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

/// What the solid below a node has in common with the plane z = 0, faces that lie in it included (a closed set, as
/// OpenSCAD's projection(cut = true)). Curves within `tolerance`; grid as profile_boolean.
Profile section(const SolidTree& tree, std::uint32_t node, double tolerance, double grid);

/// The shadow of a closed mesh on the plane z = 0 from light along z.
Profile shadow(const TriangleMesh& mesh, double grid);

}  // namespace cardioid::csg

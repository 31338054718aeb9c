#pragma once
#include <span>

#include "csg/exact/boolean/exact_solid.hpp"
#include "rt_core/scene/solid_op.hpp"

namespace cardioid::csg {

/// The boolean of closed solids: the union or intersection of all, or the first without the rest. Exact arithmetic
/// (CGAL's corefinement, and Nef polyhedra where that cannot), regularised: faces that coincide leave no membrane.
/// Throws Error(bad_input) where a mesh is open or runs through itself in a way that leaves no solid.
ExactSolid mesh_boolean(SolidOp op, std::vector<ExactSolid> parts);

/// The same by Nef polyhedra alone: slower, for everything that is closed.
ExactSolid nef_boolean(SolidOp op, std::span<const ExactSolid> parts);

/// Convex parts whose union is a closed mesh, each as its corners; one part where the mesh is convex.
std::vector<std::vector<Vec3d>> convex_parts(const TriangleMesh& mesh);

}  // namespace cardioid::csg

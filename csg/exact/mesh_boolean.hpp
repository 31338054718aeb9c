#pragma once
#include <span>

#include "rt_core/scene/solid_op.hpp"
#include "rt_core/scene/triangle_mesh.hpp"

namespace cardioid::csg {

/// The boolean of closed meshes: the union or intersection of all, or the first without the rest. Exact arithmetic
/// (CGAL's corefinement, and Nef polyhedra where that cannot), regularised: faces that coincide leave no membrane.
/// Corners are rounded to double at the end. Throws Error(bad_input) where a mesh is open or runs through itself in a
/// way that leaves no solid.
TriangleMesh mesh_boolean(SolidOp op, std::vector<TriangleMesh> parts);

/// The same by Nef polyhedra alone: slower, for everything that is closed.
TriangleMesh nef_boolean(SolidOp op, std::span<const TriangleMesh> parts);

/// Convex parts whose union is a closed mesh, each as its corners; one part where the mesh is convex.
std::vector<std::vector<Vec3d>> convex_parts(const TriangleMesh& mesh);

}  // namespace cardioid::csg

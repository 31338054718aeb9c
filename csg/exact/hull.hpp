#pragma once
#include <span>

#include "rt_core/scene/triangle_mesh.hpp"

namespace cardioid::csg {

/// The convex hull of points as a closed mesh; without triangles where all lie in a plane. Exact predicates: no corner
/// of the hull is lost, and corners keep their coordinates. Points must be finite. O(n log n).
TriangleMesh convex_hull(std::span<const Vec3d> points);

/// The convex hull of plane points, counter-clockwise; empty where all lie on a line.
std::vector<Vec2d> convex_hull(std::span<const Vec2d> points);

/// What convex meshes have in common: exact but for the rounding of corners at the end. Time grows with the triangles
/// of all times those of the result.
TriangleMesh convex_intersection(std::span<const TriangleMesh> parts);

/// Whether a closed mesh encloses as much as the hull of its corners, to what six digits tell.
bool is_convex(const TriangleMesh& mesh);

}  // namespace cardioid::csg

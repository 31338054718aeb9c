#pragma once
#include "rt_core/scene/solid.hpp"

namespace cardioid::test {

/// Whether p is inside a closed mesh: by counting how often a ray along the unit vector d crosses it, all triangles
/// tried. May be wrong where the ray passes close to an edge.
bool inside_by_parity(const TriangleMesh& mesh, Vec3d p, Vec3d d);

/// Distance of p from the nearest triangle, all of them tried.
double distance_to(const TriangleMesh& mesh, Vec3d p);

}  // namespace cardioid::test

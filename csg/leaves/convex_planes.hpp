#pragma once
#include <cstddef>
#include <vector>

#include "csg/leaves/leaf.hpp"

namespace cardioid::csg {

/// The planes of a closed mesh that is convex, triangles of one face as one plane, which is what six digits tell of
/// them. Empty where it is not convex or has more than `limit` faces. O(triangles limit).
std::vector<Plane> convex_planes(const TriangleMesh& mesh, std::size_t limit);

}  // namespace cardioid::csg

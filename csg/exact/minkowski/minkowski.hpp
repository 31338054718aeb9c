#pragma once
#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

/// How much work a Minkowski sum may be unless told otherwise: points of which hulls are taken, about 100 bytes and a
/// microsecond each.
inline constexpr double most_minkowski_points = 5e7;

/// The Minkowski sum of solids as meshes whose union it is, each convex. Solids that are no union of convex parts are
/// cut into such by CGAL; solids that are empty are left out, as in OpenSCAD. Throws Error(limit) where more than
/// `most_points` sums of corners would be needed.
std::vector<TriangleMesh> minkowski(const SolidTree& tree, const std::vector<std::uint32_t>& nodes, double tolerance,
                                    double most_points = most_minkowski_points);

}  // namespace cardioid::csg

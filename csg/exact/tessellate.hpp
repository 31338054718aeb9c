#pragma once
#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

/// Corners of a circle of radius r whose chords stay within `tolerance` of it: a multiple of 4 from 12 to 720.
int fine_corners(double r, double tolerance);

/// A leaf of the tree as a closed mesh in the world, its curves within about `tolerance` [scene units]. Meshes and
/// polyhedra are themselves. Throws Error(bad_input) for a half space, which no mesh bounds.
TriangleMesh tessellate(const SolidTree& tree, const Leaf& leaf, double tolerance);

/// A box around a leaf in the world: exact for what is flat, balls and cones; of others within a share of 1e-4.
Box3d tight_bounds(const SolidTree& tree, const Leaf& leaf);

/// A box around the leaves below a node.
Box3d tight_bounds(const SolidTree& tree, std::uint32_t node);

}  // namespace cardioid::csg

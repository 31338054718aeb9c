#pragma once
#include <vector>

#include "rt_core/api/progress.hpp"
#include "rt_core/math/box.hpp"
#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

/// The solid below a node as one closed mesh, by exact booleans over its leaves, whose curves are kept within
/// `tolerance` [scene units]. Empty where nothing is left of it. Throws Error(bad_input) where the solid has no end or
/// a mesh is open, Error(interrupted) soon after progress->interrupted(). Booleans that do not need each other run in
/// parallel; the result is the same for any number of threads.
TriangleMesh evaluate_mesh(const SolidTree& tree, std::uint32_t node, double tolerance, Progress* progress = nullptr);

/// The leaf at `leaf`, which stands below `node`, as a closed mesh: a half space as a box that is large enough there.
TriangleMesh evaluate_leaf(const SolidTree& tree, std::uint32_t leaf, std::uint32_t node, double tolerance);

/// Points whose hull is that of the node: the corners of what it unites; booleans are evaluated.
std::vector<Vec3d> spanning_points(const SolidTree& tree, std::uint32_t node, double tolerance);

/// The smallest box around the node, booleans evaluated.
Box3d exact_bounds(const SolidTree& tree, std::uint32_t node, double tolerance);

/// The nodes below `node` and itself, each once, children before their parents.
std::vector<std::uint32_t> nodes_below(const SolidTree& tree, std::uint32_t node);

}  // namespace cardioid::csg

#pragma once
#include <string>
#include <vector>

#include "rt_core/scene/scene.hpp"

namespace cardioid::cli {

/// "box", "sphere", ... "mesh".
const char* leaf_kind_name(LeafKind kind);

/// The part of a tree under one of its nodes, as a tree of its own with that node as its only root.
SolidTree subtree(const SolidTree& tree, std::uint32_t root);

/// `room.csg:12 (sphere, material "red")`, after the first leaf of a subtree.
std::string solid_name(const SolidTree& solid, const Scene& scene);

/// "(1, 2.5, -3)", 6 digits.
std::string point_text(Vec3d p);

}  // namespace cardioid::cli

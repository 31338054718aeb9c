#pragma once
#include <vector>

#include "rt_core/math/box.hpp"
#include "rt_core/scene/solid.hpp"

namespace cardioid::formats::povray {

/// Box around a leaf in its local space; a half space has none that ends.
Box3d local_box(const Leaf& leaf, const SolidTree& solids);
/// The same in the world.
Box3d world_box(const Leaf& leaf, const SolidTree& solids);
/// A box around what each node makes, not always the smallest.
std::vector<Box3d> node_boxes(const SolidTree& solids);

}  // namespace cardioid::formats::povray

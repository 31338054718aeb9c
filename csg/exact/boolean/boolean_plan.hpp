#pragma once
#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

/// A boolean to be done, or a leaf.
struct PlannedBoolean {
    SolidOp op = SolidOp::leaf;
    std::uint32_t leaf = 0;            ///< of SolidTree::leaves
    std::vector<std::uint32_t> parts;  ///< steps of the plan; of a subtraction, what it is taken from is the first
    std::uint32_t height = 0;          ///< 0 for a leaf, else more than that of any part
};

/// The booleans below a node with as few of them as can be: unions of unions, intersections of intersections and what
/// subtractions take away are one step each. Parts stand before what needs them, the node itself is the last.
std::vector<PlannedBoolean> plan_booleans(const SolidTree& tree, std::uint32_t node);

}  // namespace cardioid::csg

#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

/// An n-ary AND or OR that counts which of its inputs hold: it is true where the count reaches `threshold`
/// (n for AND, 1 for OR). 12 bytes.
struct Gate {
    std::uint32_t parent;  ///< gate that this one feeds; Gates::none for the root
    std::int32_t threshold;
    std::int32_t at_rest;  ///< the count while a ray is outside every leaf
};

/// What a leaf feeds: its gate and whether by its complement.
struct Input {
    std::uint32_t gate : 31;
    std::uint32_t negated : 1;
};

/// A boolean tree as gates over leaves, in negation normal form: A - B - C is AND(A, not B, not C), so chains of
/// differences are flat. Only leaves are negated; leaves that can never matter are gone.
struct GateTree {
    static constexpr std::uint32_t none = 0x7FFFFFFFU;
    std::vector<Gate> gates;        ///< children before parents; the root is the last; empty: the solid is empty
    std::vector<Input> inputs;      ///< one for each leaf
    Box3d bounds;                   ///< of the solid
    std::uint32_t required = none;  ///< an input without which the solid is empty, where there is one
};

/// The same with what only the making of a region needs; both lists are parallel to `inputs`.
struct Gates : GateTree {
    std::vector<std::uint32_t> leaves;  ///< SolidTree leaf of each input
    std::vector<Box3d> boxes;           ///< where this leaf can matter; may be infinite
};

/// The union of the given nodes of the tree as gates; leaf_boxes has one box for every leaf of the tree.
Gates make_gates(const SolidTree& tree, std::span<const std::uint32_t> nodes, const std::vector<Box3d>& leaf_boxes);

}  // namespace cardioid::csg

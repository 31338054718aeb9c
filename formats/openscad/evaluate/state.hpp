#pragma once
#include <span>
#include <string>

#include "formats/openscad/evaluate/call_table.hpp"
#include "formats/openscad/evaluate/results.hpp"

namespace cardioid::formats::openscad {

/// What the calls around a call say.
struct State {
    Affine to_world;
    Affine in_plane;                             ///< of plane figures, since the nearest extrusion
    std::uint32_t material = Leaf::no_material;  ///< of the nearest material() or, of colours, the outermost since
    std::uint32_t fallback = Leaf::no_material;  ///< in a subtrahend: the material of what is cut
    bool from_colour = false;
    bool fixed = false;  ///< the material is not to change any more

    /// That of a leaf here.
    [[nodiscard]] std::uint32_t leaf_material() const {
        if (material != Leaf::no_material) return material;
        return fallback != Leaf::no_material ? fallback : 0;
    }
    void set_material(std::uint32_t index) {
        if (fixed) return;
        material = index;
        from_colour = false;
    }
    void set_colour(std::uint32_t index) {
        if (fixed || from_colour) return;  // of colours, the outermost wins
        material = index;
        from_colour = true;
    }
};

enum class Dimension : std::uint8_t { unknown, plane, solid };

/// A call whose children are being evaluated.
struct Frame {
    std::span<const std::uint32_t> rest;  ///< children still to come
    const Ast* ast = nullptr;
    const Call* call = nullptr;  ///< null for the file itself
    Node node = Node::group;
    State state;                  ///< of the next child
    ResultMark mark;              ///< where its results begin
    std::size_t first_scope = 0;  ///< of its material markers
    Dimension dimension = Dimension::unknown;
    std::size_t first_leaf = 0;  ///< of SolidTree::leaves, where those of its children begin
    bool first_done = false;     ///< a child that counts was evaluated
    bool empty = false;          ///< a boolean that is known to be empty
    bool empty_child = false;    ///< a child that counts came to nothing
    bool backdrop = false;       ///< marked by `%`: drawn, but no part of its parent

    [[nodiscard]] bool is_boolean() const { return node == Node::difference || node == Node::intersection; }
    /// Children stay apart: the results of one are one.
    [[nodiscard]] bool joins_children() const { return is_boolean() || node == Node::minkowski; }
    [[nodiscard]] bool is_extrusion() const { return node >= Node::linear_extrude && node <= Node::roof; }
    [[nodiscard]] std::string where() const { return ast->where(call->place); }
};

}  // namespace cardioid::formats::openscad

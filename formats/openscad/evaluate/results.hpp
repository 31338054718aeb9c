#pragma once
#include <vector>

#include "formats/openscad/geometry/extrusions.hpp"

namespace cardioid::formats::openscad {

/// Where the results of a child begin.
struct ResultMark {
    std::size_t solid = 0, plane = 0;
};

/// The call that made something, for messages.
struct Origin {
    std::string where;
    std::uint32_t line = 0;
};

/// Results of the calls that are being evaluated, on two stacks: nodes of the SolidTree and plane figures. A group
/// leaves its children's results where they are, so nesting costs nothing.
class Results {
public:
    explicit Results(ShapeContext& shapes) : shapes_(shapes) {}

    [[nodiscard]] ResultMark mark() const { return {solids_.size(), planes_.size()}; }
    [[nodiscard]] bool has_solids(const ResultMark& since) const { return solids_.size() > since.solid; }
    [[nodiscard]] bool has_planes(const ResultMark& since) const { return planes_.size() > since.plane; }
    /// The results since the mark are taken off.
    void drop(const ResultMark& since);
    std::vector<std::uint32_t> take_solids(const ResultMark& since);
    std::vector<Plane> take_planes(const ResultMark& since);

    void add_leaf(const Leaf& leaf);
    /// Adds a shape carried by `to_world`; false, and a warning, where the transforms leave nothing of it.
    bool place(const Shape& shape, const Affine& to_world, std::uint32_t material, const Origin& origin);
    /// Puts a node back that was taken.
    void add_node(std::uint32_t node) { solids_.push_back(node); }
    void add_plane(Plane plane) { planes_.push_back(std::move(plane)); }
    /// All since the mark become one: their union.
    void join(const ResultMark& since);
    /// All since the mark become one: the first minus the rest, or what they have in common.
    void combine(SolidOp op, const ResultMark& since);
    /// The material of a node's first leaf.
    [[nodiscard]] std::uint32_t material_of(std::uint32_t node) const { return material_of_node_[node]; }
    /// The material of the first leaf of the last solid.
    [[nodiscard]] std::uint32_t last_material() const { return material_of_node_[solids_.back()]; }

private:
    void combine_solids(SolidOp op, std::size_t first);

    ShapeContext& shapes_;
    std::vector<std::uint32_t> solids_;
    std::vector<Plane> planes_;
    std::vector<std::uint32_t> material_of_node_;  ///< of each node's first leaf
};

}  // namespace cardioid::formats::openscad

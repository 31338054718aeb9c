#include "csg/compile.hpp"

#include <algorithm>
#include <map>

#include "csg/leaves/leaf.hpp"
#include "csg/region/leaf_region.hpp"
#include "csg/region/solid_region.hpp"

namespace cardioid::csg {
namespace {

/// Numbers printed with six digits put faces that are meant to coincide apart by up to this share of the solid's size.
constexpr double six_digit_weld = 1e-6;
/// Rounding of double arithmetic puts them apart by at most this share (measured: 3e-13, with margin).
constexpr double rounding = 1e-12;
/// A ray that leaves a surface finds it again within this share of the size.
constexpr double start_share = 1e-9;

/// The length that coordinates are rounded in proportion to: the diagonal, or the distance from the origin.
double size_of(const Box3d& box) { return std::max(box.diagonal(), max_component(max(abs(box.lo), abs(box.hi)))); }

class RegionMaker {
public:
    RegionMaker(const SolidTree& tree, bool six_digits) : tree_(tree), shapes_(tree), six_digits_(six_digits) {
        Box3d all;
        for (const Leaf& leaf : tree.leaves) {
            boxes_.push_back(leaf_bounds(tree, leaf));
            if (boxes_.back().bounded()) all.include(boxes_.back());
        }
        scene_size_ = all.empty() ? 1 : size_of(all);
        scene_tolerances_ = std::make_shared<const Tolerances>(tolerances(scene_size_));
    }
    /// The union of the nodes as one region; null where it is empty.
    std::unique_ptr<SolidRegion> make(std::span<const std::uint32_t> nodes) {
        Gates gates = make_gates(tree_, nodes, boxes_);
        if (gates.gates.empty()) return nullptr;
        const Box3d bounds = gates.bounds;
        std::vector<SolvedLeaf> leaves;
        std::vector<std::shared_ptr<const Shape>> shapes;
        leaves.reserve(gates.leaves.size());
        for (const std::uint32_t l : gates.leaves) {
            shapes.push_back(shapes_.shape_of(tree_.leaves[l]));
            leaves.push_back(solve(tree_.leaves[l], shapes.back().get()));
        }
        return std::make_unique<SolidRegion>(std::move(gates), std::move(leaves), std::move(shapes),
                                             tolerances(bounds.bounded() ? size_of(bounds) : scene_size_));
    }
    /// A node that is a leaf as a region; `shared` keeps what it points to.
    std::unique_ptr<LeafRegion> make_leaf(const Leaf& leaf, std::vector<std::shared_ptr<const void>>& shared) {
        if (shared.empty()) shared.push_back(scene_tolerances_);
        const auto shape = shapes_.shape_of(leaf);
        if (shape) shared.push_back(shape);
        return std::make_unique<LeafRegion>(solve(leaf, shape.get()), leaf_bounds(tree_, leaf), *scene_tolerances_);
    }

private:
    [[nodiscard]] Tolerances tolerances(double size) const {
        const double weld = six_digits_ ? six_digit_weld * size : 0;
        return {rounding * size, weld, std::max(weld, start_share * size)};
    }

    const SolidTree& tree_;
    ShapeMaker shapes_;
    std::vector<Box3d> boxes_;
    bool six_digits_;
    double scene_size_;
    std::shared_ptr<const Tolerances> scene_tolerances_;
};

/// The model as a list of nodes that are no unions, in the order of the file.
std::vector<std::uint32_t> members(const SolidTree& tree) {
    std::vector<std::uint32_t> out, pending(tree.roots.rbegin(), tree.roots.rend());
    while (!pending.empty()) {
        const std::uint32_t i = pending.back();
        pending.pop_back();
        const SolidNode& node = tree.nodes[i];
        if (node.op == SolidOp::unite || (node.count == 1 && node.op != SolidOp::leaf)) {
            for (std::uint32_t c = node.count; c-- > 0;) pending.push_back(tree.children[node.first + c]);
        } else {
            out.push_back(i);
        }
    }
    return out;
}

/// The material of all parts (not cutters) below a node, or no_material where they differ.
std::uint32_t only_material(const SolidTree& tree, std::uint32_t node) {
    std::uint32_t only = Leaf::no_material;
    std::vector<std::uint32_t> pending{node};
    while (!pending.empty()) {
        const SolidNode& n = tree.nodes[pending.back()];
        pending.pop_back();
        if (n.op == SolidOp::leaf) {
            const std::uint32_t material = tree.leaves[n.first].material;
            if (only != Leaf::no_material && material != only) return Leaf::no_material;
            only = material;
            continue;
        }
        const std::uint32_t parts = n.op == SolidOp::subtract ? std::min(n.count, 1U) : n.count;
        for (std::uint32_t c = 0; c < parts; ++c) pending.push_back(tree.children[n.first + c]);
    }
    return only;
}

}  // namespace

Geometry compile(const Scene& scene, const std::vector<bool>& transparent) {
    const SolidTree& tree = scene.solids;
    const auto lets_light_in = [&](std::uint32_t m) { return m < transparent.size() && transparent[m]; };
    RegionMaker maker(tree, scene.six_digits);
    Geometry out;
    // Opaque members stand alone, so that Embree sorts them. Members of one transparent material are one solid: no
    // light may see the faces inside their union.
    std::vector<std::vector<std::uint32_t>> solids;
    std::map<std::uint32_t, std::size_t> solid_of;
    for (const std::uint32_t member : members(tree)) {
        const SolidNode& node = tree.nodes[member];
        const std::uint32_t material = only_material(tree, member);
        if (lets_light_in(material)) {
            const auto [place, fresh] = solid_of.emplace(material, solids.size());
            if (fresh) solids.emplace_back();
            solids[place->second].push_back(member);
        } else if (node.op == SolidOp::leaf && tree.leaves[node.first].kind == LeafKind::mesh) {
            const Leaf& leaf = tree.leaves[node.first];
            out.surfaces.push_back(
                {tree.meshes[leaf.data], leaf.to_world, leaf.material == Leaf::no_material ? 0 : leaf.material});
        } else {
            solids.push_back({member});
        }
    }
    for (const auto& nodes : solids) {
        const SolidNode& first = tree.nodes[nodes[0]];
        if (nodes.size() == 1 && first.op == SolidOp::leaf)
            out.regions.push_back(maker.make_leaf(tree.leaves[first.first], out.shared));
        else if (auto region = maker.make(nodes))
            out.regions.push_back(std::move(region));
    }
    return out;
}

std::unique_ptr<Region> compile_whole(const SolidTree& solids, bool six_digits) {
    return RegionMaker(solids, six_digits).make(solids.roots);
}

}  // namespace cardioid::csg

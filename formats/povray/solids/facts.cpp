#include "formats/povray/solids/facts.hpp"

#include <algorithm>

#include "formats/povray/solids/bounds.hpp"

namespace cardioid::formats::povray {

namespace {

using Node = SolidFacts::Node;

Node gather(const SolidNode& node, const SolidTree& solids, const std::vector<Node>& below) {
    Node out;
    const auto child = [&](std::uint32_t i) -> const Node& { return below[solids.children[node.first + i]]; };
    std::uint32_t making = 0;
    for (std::uint32_t i = 0; i < node.count; ++i) {
        if (child(i).empty) continue;
        out.material = making == 0 || child(i).material == out.material ? child(i).material : SolidFacts::mixed;
        out.transparent = out.transparent || child(i).transparent;
        ++making;
    }
    out.empty = node.op == SolidOp::unite       ? making == 0
                : node.op == SolidOp::intersect ? making == 0 || making < node.count
                                                : node.count == 0 || child(0).empty;
    return out;
}

}  // namespace

SolidFacts::SolidFacts(const Scene& scene, const Materials& materials) : boxes(node_boxes(scene.solids)) {
    const SolidTree& solids = scene.solids;
    nodes.reserve(solids.nodes.size());
    for (const SolidNode& node : solids.nodes) {
        if (node.op != SolidOp::leaf) {
            nodes.push_back(gather(node, solids, nodes));
            continue;
        }
        const std::uint32_t material = material_index(solids.leaves[node.first]);
        nodes.push_back({.transparent = materials.all[material].transparent, .material = material});
    }
    // Parents stand behind their children, so that going backwards each is told before it tells.
    for (std::size_t i = solids.nodes.size(); i-- > 0;) {
        const SolidNode& node = solids.nodes[i];
        if (node.op == SolidOp::leaf) continue;
        for (std::uint32_t k = 0; k < node.count; ++k) {
            Node& child = nodes[solids.children[node.first + k]];
            child.cuts = std::max(child.cuts, nodes[i].cuts + (node.op == SolidOp::subtract && k > 0 ? 1 : 0));
            child.abuts = child.abuts || nodes[i].abuts || (node.op == SolidOp::unite && k > 0 && nodes[i].transparent);
        }
    }
}

std::vector<std::uint32_t> SolidFacts::children(const SolidTree& solids, std::uint32_t index) const {
    const SolidNode& node = solids.nodes[index];
    std::vector<std::uint32_t> out;
    if (node.op == SolidOp::leaf) return out;
    for (std::uint32_t i = 0; i < node.count; ++i)
        if (const std::uint32_t child = solids.children[node.first + i]; !nodes[child].empty) out.push_back(child);
    return out;
}

}  // namespace cardioid::formats::povray

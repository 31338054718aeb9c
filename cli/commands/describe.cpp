#include "cli/commands/describe.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace cardioid::cli {
namespace {

/// The nodes under `root` and itself, in ascending order: children before their parents.
std::vector<std::uint32_t> nodes_under(const SolidTree& tree, std::uint32_t root) {
    std::vector<std::uint32_t> found{root};
    for (std::size_t i = 0; i < found.size(); ++i) {
        const SolidNode& node = tree.nodes[found[i]];
        if (node.op == SolidOp::leaf) continue;
        const auto first = tree.children.begin() + node.first;
        found.insert(found.end(), first, first + node.count);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace

const char* leaf_kind_name(LeafKind kind) {
    switch (kind) {
        case LeafKind::box:
            return "box";
        case LeafKind::sphere:
            return "sphere";
        case LeafKind::cone:
            return "cone";
        case LeafKind::torus:
            return "torus";
        case LeafKind::half_space:
            return "half_space";
        case LeafKind::prism:
            return "prism";
        case LeafKind::revolution:
            return "revolution";
        case LeafKind::mesh:
            return "mesh";
        case LeafKind::form:
            return "form";
    }
    return "";
}

SolidTree subtree(const SolidTree& tree, std::uint32_t root) {
    const std::vector<std::uint32_t> kept = nodes_under(tree, root);
    const auto new_index = [&](std::uint32_t old) {
        return static_cast<std::uint32_t>(std::lower_bound(kept.begin(), kept.end(), old) - kept.begin());
    };
    SolidTree part;
    part.profiles = tree.profiles;
    part.meshes = tree.meshes;
    part.forms = tree.forms;
    for (const std::uint32_t old : kept) {
        const SolidNode& node = tree.nodes[old];
        if (node.op == SolidOp::leaf) {
            part.add_leaf(tree.leaves[node.first]);
            continue;
        }
        std::vector<std::uint32_t> over;
        for (std::uint32_t i = 0; i < node.count; ++i) over.push_back(new_index(tree.children[node.first + i]));
        part.add_node(node.op, over);
    }
    part.roots = {new_index(root)};
    return part;
}

std::string solid_name(const SolidTree& solid, const Scene& scene) {
    if (solid.leaves.empty()) return scene.file;
    const Leaf& leaf = solid.leaves.front();
    const char* const kind = solid.leaves.size() > 1 ? "solid" : leaf_kind_name(leaf.kind);
    if (leaf.material >= scene.materials.size()) return fmt::format("{}:{} ({})", scene.file, leaf.line, kind);
    return fmt::format("{}:{} ({}, material \"{}\")", scene.file, leaf.line, kind, scene.materials[leaf.material].name);
}

std::string point_text(Vec3d p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z); }

}  // namespace cardioid::cli

#include "formats/openscad/prune.hpp"

#include <algorithm>
#include <utility>

namespace cardioid::formats::openscad {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

std::vector<bool> needed_nodes(const SolidTree& solids) {
    std::vector<bool> needed(solids.nodes.size());
    for (const std::uint32_t root : solids.roots) needed[root] = true;
    for (std::size_t i = solids.nodes.size(); i-- > 0;) {  // parents stand behind their children
        const SolidNode& node = solids.nodes[i];
        if (!needed[i] || node.op == SolidOp::leaf) continue;
        for (std::uint32_t c = 0; c < node.count; ++c) needed[solids.children[node.first + c]] = true;
    }
    return needed;
}

/// The new index of an element that is kept; it is moved over at its first use.
template <class T>
std::uint32_t move_over(std::uint32_t index, std::vector<std::uint32_t>& moved, std::vector<T>& from,
                        std::vector<T>& to) {
    if (moved[index] == none) {
        moved[index] = static_cast<std::uint32_t>(to.size());
        to.push_back(std::move(from[index]));
    }
    return moved[index];
}

}  // namespace

void prune(SolidTree& old) {
    const std::vector<bool> needed = needed_nodes(old);
    if (std::find(needed.begin(), needed.end(), false) == needed.end()) return;
    SolidTree out;
    std::vector<std::uint32_t> node_at(old.nodes.size(), none);
    std::vector<std::uint32_t> profile_at(old.profiles.size(), none), mesh_at(old.meshes.size(), none);
    for (std::size_t i = 0; i < old.nodes.size(); ++i) {
        if (!needed[i]) continue;
        const SolidNode& node = old.nodes[i];
        if (node.op == SolidOp::leaf) {
            Leaf leaf = old.leaves[node.first];
            if (leaf.kind == LeafKind::prism || leaf.kind == LeafKind::revolution)
                leaf.data = move_over(leaf.data, profile_at, old.profiles, out.profiles);
            if (leaf.kind == LeafKind::form) leaf.data = out.add_form(old.forms[leaf.data]);
            if (leaf.kind == LeafKind::mesh) leaf.data = move_over(leaf.data, mesh_at, old.meshes, out.meshes);
            node_at[i] = out.add_leaf(leaf);
            continue;
        }
        std::vector<std::uint32_t> over;
        for (std::uint32_t c = 0; c < node.count; ++c) over.push_back(node_at[old.children[node.first + c]]);
        node_at[i] = out.add_node(node.op, over);
    }
    for (const std::uint32_t root : old.roots) out.roots.push_back(node_at[root]);
    old = std::move(out);
}

void renumber(TriangleMesh& mesh) {
    std::vector<std::uint32_t> moved(mesh.vertices.size(), none);
    std::vector<Vec3d> vertices;
    vertices.reserve(mesh.vertices.size());
    for (auto& triangle : mesh.triangles)
        for (std::uint32_t& v : triangle) v = move_over(v, moved, mesh.vertices, vertices);
    mesh.vertices = std::move(vertices);
}

}  // namespace cardioid::formats::openscad

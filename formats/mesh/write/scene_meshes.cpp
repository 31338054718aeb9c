#include "formats/mesh/write/scene_meshes.hpp"

#include <map>

#include "csg/exact/evaluate_mesh.hpp"
#include "csg/exact/tessellate.hpp"
#include "csg/exact/walk.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats {

namespace {

std::uint32_t material_of(const SolidTree& tree, std::uint32_t node) {
    while (tree.nodes[node].op != SolidOp::leaf && tree.nodes[node].count > 0)
        node = tree.children[tree.nodes[node].first];
    if (tree.nodes[node].op != SolidOp::leaf) return 0;
    const std::uint32_t material = tree.leaves[tree.nodes[node].first].material;
    return material == Leaf::no_material ? 0 : material;
}

double usual_tolerance(const SolidTree& tree) {
    constexpr double share = 1e-4;
    Box3d box;
    for (const std::uint32_t root : tree.roots)
        csg::for_each_leaf(tree, root, [&](const Leaf& leaf) {
            if (leaf.kind != LeafKind::half_space) box.include(csg::tight_bounds(tree, leaf));
        });
    return share * box.diagonal();
}

std::string name_of(const Scene& scene, std::uint32_t material) {
    return material < scene.materials.size() && !scene.materials[material].name.empty()
               ? scene.materials[material].name
               : "material" + std::to_string(material);
}

}  // namespace

std::vector<MeshPart> scene_meshes(const Scene& scene, double tolerance, bool one) {
    SolidTree tree = scene.solids;
    if (!(tolerance > 0)) tolerance = usual_tolerance(tree);
    std::map<std::uint32_t, std::vector<std::uint32_t>> roots;
    for (const std::uint32_t root : tree.roots) roots[one ? 0 : material_of(tree, root)].push_back(root);
    std::vector<MeshPart> out;
    try {
        for (const auto& [material, nodes] : roots) {
            MeshPart part{name_of(scene, material),
                          csg::evaluate_mesh(tree, tree.add_node(SolidOp::unite, nodes), tolerance)};
            if (!part.mesh.triangles.empty()) out.push_back(std::move(part));
        }
    } catch (const Error& e) {
        throw Error(e.code(), scene.file + ": " + e.what());
    }
    if (out.empty()) throw Error(ErrorCode::bad_input, scene.file + ": found no solid, wanted one to write as a mesh");
    return out;
}

}  // namespace cardioid::formats

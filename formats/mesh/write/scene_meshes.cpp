#include "formats/mesh/write/scene_meshes.hpp"

#include <atomic>
#include <exception>
#include <map>
#include <numeric>

#include "csg/exact/evaluate_mesh.hpp"
#include "csg/exact/tessellate.hpp"
#include "csg/exact/walk.hpp"
#include "rt_core/api/error.hpp"
#include "rt_core/api/parallel.hpp"

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

void append(TriangleMesh& to, const TriangleMesh& mesh) {
    const auto first = static_cast<std::uint32_t>(to.vertices.size());
    to.vertices.insert(to.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const auto& [a, b, c] : mesh.triangles) to.triangles.push_back({first + a, first + b, first + c});
    to.closed = to.closed && mesh.closed;
}

std::vector<MeshPart> united_parts(const Scene& scene, SolidTree& tree, double tolerance, const MeshWish& wish) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> roots;
    for (const std::uint32_t root : tree.roots) roots[wish.one ? 0 : material_of(tree, root)].push_back(root);
    std::vector<MeshPart> out;
    for (const auto& [material, nodes] : roots) {
        const std::string name = name_of(scene, material);
        const std::uint32_t whole = tree.add_node(SolidOp::unite, nodes);
        MeshPart part{name, name, csg::evaluate_mesh(tree, whole, tolerance, wish.progress)};
        if (!part.mesh.triangles.empty()) out.push_back(std::move(part));
    }
    return out;
}

/// What became of a region: its mesh, or why it has none.
struct RegionMesh {
    TriangleMesh mesh;
    std::exception_ptr failure;
};

/// How far the work on all regions is, each as much of it as it has leaves.
struct AllRegions {
    Progress* progress;
    double leaves = 0;
    std::atomic<double> done{0};
};

/// What one region adds to that.
class RegionProgress final : public Progress {
public:
    RegionProgress(AllRegions& all, double leaves) : all_(all), leaves_(leaves) {}
    void update(double share) override {
        double told = told_.load();
        while (share > told && !told_.compare_exchange_weak(told, share)) {
        }
        if (share > told && all_.progress) all_.progress->update((all_.done += leaves_ * (share - told)) / all_.leaves);
    }
    [[nodiscard]] bool interrupted() const noexcept override { return all_.progress && all_.progress->interrupted(); }

private:
    AllRegions& all_;
    double leaves_;
    std::atomic<double> told_{0};
};

/// All regions at once, each by one thread; what fails is told in the order of the file.
std::vector<RegionMesh> region_meshes(const SolidTree& tree, double tolerance, Progress* progress) {
    std::vector<RegionMesh> out(tree.roots.size());
    std::vector<double> leaves(out.size(), 1);
    for (std::size_t i = 0; i < out.size(); ++i)
        csg::for_each_leaf(tree, tree.roots[i], [&](const Leaf&) { ++leaves[i]; });
    AllRegions all{progress, std::accumulate(leaves.begin(), leaves.end(), 0.0)};
    if (progress) progress->begin("evaluate");
    parallel_for(static_cast<std::int64_t>(out.size()), [&](std::int64_t i) {
        const auto at = static_cast<std::size_t>(i);
        RegionMesh& region = out[at];
        RegionProgress share(all, leaves[at]);
        try {
            region.mesh = csg::evaluate_mesh(tree, tree.roots[at], tolerance, &share);
        } catch (...) {
            region.failure = std::current_exception();
        }
        share.update(1);
    });
    return out;
}

std::vector<MeshPart> region_parts(const Scene& scene, double tolerance, const MeshWish& wish) {
    std::vector<MeshPart> out;
    std::vector<RegionMesh> regions = region_meshes(scene.solids, tolerance, wish.progress);
    for (std::size_t i = 0; i < regions.size(); ++i) {
        MeshPart part{scene.names[i], name_of(scene, material_of(scene.solids, scene.solids.roots[i])),
                      std::move(regions[i].mesh)};
        try {
            if (regions[i].failure) std::rethrow_exception(regions[i].failure);
        } catch (const Error& e) {
            if (e.code() != ErrorCode::bad_input) throw;
            if (wish.notes) wish.notes->push_back(scene.file + ": region " + part.name + " is left out: " + e.what());
            continue;
        }
        if (part.mesh.triangles.empty()) continue;
        if (wish.one && !out.empty())
            append(out[0].mesh, part.mesh);
        else
            out.push_back(std::move(part));
    }
    return out;
}

}  // namespace

std::vector<MeshPart> scene_meshes(const Scene& scene, const MeshWish& wish) {
    SolidTree tree = scene.solids;
    const double tolerance = wish.tolerance > 0 ? wish.tolerance : usual_tolerance(tree);
    std::vector<MeshPart> out;
    try {
        out = scene.names.empty() ? united_parts(scene, tree, tolerance, wish) : region_parts(scene, tolerance, wish);
    } catch (const Error& e) {
        throw Error(e.code(), scene.file + ": " + e.what());
    }
    if (out.empty()) throw Error(ErrorCode::bad_input, scene.file + ": found no solid, wanted one to write as a mesh");
    return out;
}

}  // namespace cardioid::formats

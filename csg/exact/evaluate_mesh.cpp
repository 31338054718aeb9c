#include "csg/exact/evaluate_mesh.hpp"

#include <algorithm>
#include <map>

#include "csg/exact/boolean/boolean_plan.hpp"
#include "csg/exact/boolean/run_plan.hpp"
#include "csg/exact/mesh_cache.hpp"
#include "csg/exact/tessellate.hpp"
#include "csg/exact/walk.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::csg {

namespace {

/// A box around all leaves below a node that have an end.
Box3d reach_of(const SolidTree& tree, std::uint32_t node) {
    Box3d out;
    for_each_leaf(tree, node, [&](const Leaf& leaf) {
        if (leaf.kind != LeafKind::half_space) out.include(tight_bounds(tree, leaf));
    });
    return out;
}

bool is_bounded(const SolidTree& tree, std::uint32_t node) {
    std::map<std::uint32_t, bool> bounded;
    for (const std::uint32_t index : nodes_below(tree, node)) {
        const SolidNode& at = tree.nodes[index];
        if (at.op == SolidOp::leaf) {
            bounded[index] = tree.leaves[at.first].kind != LeafKind::half_space;
            continue;
        }
        const auto child = [&](std::uint32_t c) { return bounded[tree.children[at.first + c]]; };
        bool all = true, any = at.count == 0;
        for (std::uint32_t c = 0; c < at.count; ++c) all = all && child(c), any = any || child(c);
        bounded[index] = at.op == SolidOp::unite ? all : at.op == SolidOp::intersect ? any : at.count == 0 || child(0);
    }
    return bounded[node];
}

/// What of a half space may matter within a box, as a box of its own.
TriangleMesh thick_plate(const Affine& half_space, const Box3d& reach) {
    const Box3d local = half_space.inverse().box(reach), wide = local.padded(local.diagonal());
    const double depth = std::max(-wide.lo.z, local.diagonal());
    const Affine map =
        Affine::translation({wide.lo.x, wide.lo.y, -depth}) * Affine::scaling({wide.size().x, wide.size().y, depth});
    return tessellate({}, Leaf{.kind = LeafKind::box, .to_world = half_space * map}, 0);
}

/// What the result depends on.
ContentHash key_of(const std::vector<PlannedBoolean>& plan, const std::vector<TriangleMesh>& leaves) {
    ContentHash key;
    for (std::size_t i = 0; i < plan.size(); ++i) {
        key.add(static_cast<std::uint64_t>(plan[i].op));
        key.add(static_cast<std::uint64_t>(plan[i].parts.size()));
        for (const std::uint32_t part : plan[i].parts) key.add(std::uint64_t{part});
        key.add(leaves[i]);
    }
    return key;
}

TriangleMesh leaf_mesh(const SolidTree& tree, const Leaf& leaf, const Box3d& reach, double tolerance) {
    return leaf.kind == LeafKind::half_space ? thick_plate(leaf.to_world, reach) : tessellate(tree, leaf, tolerance);
}

}  // namespace

std::vector<std::uint32_t> nodes_below(const SolidTree& tree, std::uint32_t node) {
    std::vector<std::uint32_t> rest{node}, out;
    while (!rest.empty()) {
        const std::uint32_t index = rest.back();
        rest.pop_back();
        out.push_back(index);
        const SolidNode& at = tree.nodes[index];
        if (at.op != SolidOp::leaf)
            for (std::uint32_t c = 0; c < at.count; ++c) rest.push_back(tree.children[at.first + c]);
    }
    std::ranges::sort(out);  // children stand before their parents
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

TriangleMesh evaluate_leaf(const SolidTree& tree, std::uint32_t leaf, std::uint32_t node, double tolerance) {
    return leaf_mesh(tree, tree.leaves[tree.nodes[leaf].first], reach_of(tree, node), tolerance);
}

TriangleMesh evaluate_mesh(const SolidTree& tree, std::uint32_t node, double tolerance, Progress* progress) {
    if (!is_bounded(tree, node)) throw Error(ErrorCode::bad_input, "a solid without an end has no mesh");
    const Box3d reach = reach_of(tree, node);
    const std::vector<PlannedBoolean> plan = plan_booleans(tree, node);
    std::vector<TriangleMesh> leaves(plan.size());
    for (std::size_t i = 0; i < plan.size(); ++i)
        if (plan[i].op == SolidOp::leaf) leaves[i] = leaf_mesh(tree, tree.leaves[plan[i].leaf], reach, tolerance);
    if (plan.back().op == SolidOp::leaf) return std::move(leaves.back());
    const auto make = [&] { return std::vector{run_plan(plan, leaves, progress)}; };
    return std::move(cached(key_of(plan, leaves), make)[0]);
}

std::vector<Vec3d> spanning_points(const SolidTree& tree, std::uint32_t node, double tolerance) {
    std::vector<Vec3d> out;
    for (const std::uint32_t part : united_parts(tree, node)) {
        const TriangleMesh mesh = evaluate_mesh(tree, part, tolerance);
        out.insert(out.end(), mesh.vertices.begin(), mesh.vertices.end());
    }
    return out;
}

Box3d exact_bounds(const SolidTree& tree, std::uint32_t node, double tolerance) {
    Box3d out;
    for (const std::uint32_t part : united_parts(tree, node)) {
        if (tree.nodes[part].op == SolidOp::leaf)
            out.include(tight_bounds(tree, part));
        else
            for (const Vec3d v : evaluate_mesh(tree, part, tolerance).vertices) out.include(v);
    }
    return out;
}

}  // namespace cardioid::csg

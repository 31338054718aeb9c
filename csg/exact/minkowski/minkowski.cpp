#include "csg/exact/minkowski/minkowski.hpp"

#include <fmt/format.h>

#include "csg/exact/evaluate_mesh.hpp"
#include "csg/exact/boolean/mesh_boolean.hpp"
#include "csg/exact/mesh_cache.hpp"
#include "csg/exact/minkowski/convex_sum.hpp"
#include "csg/exact/walk.hpp"
#include "rt_core/api/error.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::csg {

namespace {

/// A solid as meshes whose union it is.
using Operand = std::vector<TriangleMesh>;

Operand operand(const SolidTree& tree, std::uint32_t node, double tolerance) {
    Operand out;
    for (const std::uint32_t part : united_parts(tree, node)) out.push_back(evaluate_mesh(tree, part, tolerance));
    return out;
}

std::vector<ConvexPart> parts_of(const Operand& solid) {
    std::vector<ConvexPart> out;
    for (const TriangleMesh& mesh : solid)
        for (std::vector<Vec3d>& corners : convex_parts(mesh))
            if (!corners.empty()) out.emplace_back(std::move(corners));
    return out;
}

void check_size(const std::vector<ConvexPart>& a, const std::vector<ConvexPart>& b, double most_points) {
    double points = 0;
    for (const ConvexPart& p : a)
        for (const ConvexPart& q : b) points += sum_points(p, q);
    if (points > most_points)
        throw Error(
            ErrorCode::limit,
            fmt::format("minkowski() of {} and {} convex parts would add {:.0f} pairs of corners, wanted at most "
                        "{:.0f}: fewer facets ($fn) are needed, or --set csg.minkowski={:.0f}",
                        a.size(), b.size(), points, most_points, points));
}

std::vector<TriangleMesh> sum_of_all(const std::vector<Operand>& operands, double most_points) {
    if (operands.size() == 1) return operands[0];
    std::vector<ConvexPart> so_far = parts_of(operands[0]);
    std::vector<TriangleMesh> out;
    for (std::size_t i = 1; i < operands.size(); ++i) {
        const std::vector<ConvexPart> next = parts_of(operands[i]);
        check_size(so_far, next, most_points);
        out.assign(so_far.size() * next.size(), {});
        parallel_for(static_cast<std::int64_t>(out.size()), [&](std::int64_t k) {
            const auto pair = static_cast<std::size_t>(k);
            out[pair] = convex_sum(so_far[pair / next.size()], next[pair % next.size()]);
        });
        so_far.clear();
        if (i + 1 < operands.size())
            for (const TriangleMesh& mesh : out) so_far.emplace_back(mesh.vertices);
    }
    return out;
}

}  // namespace

std::vector<TriangleMesh> minkowski(const SolidTree& tree, const std::vector<std::uint32_t>& nodes, double tolerance,
                                    double most_points) {
    std::vector<Operand> operands;
    ContentHash key;
    for (const std::uint32_t node : nodes) {
        Operand solid = operand(tree, node, tolerance);
        std::erase_if(solid, [](const TriangleMesh& mesh) { return mesh.triangles.empty(); });
        if (solid.empty()) continue;
        operands.push_back(std::move(solid));
        key.add(static_cast<std::uint64_t>(operands.back().size()));
        for (const TriangleMesh& mesh : operands.back()) key.add(mesh);
    }
    if (operands.empty()) return {};
    return cached(key, [&] { return sum_of_all(operands, most_points); });
}

}  // namespace cardioid::csg

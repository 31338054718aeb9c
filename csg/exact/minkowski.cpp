#include "csg/exact/minkowski.hpp"

#include <fmt/format.h>

#include "csg/exact/evaluate_mesh.hpp"
#include "csg/exact/hull.hpp"
#include "csg/exact/mesh_boolean.hpp"
#include "csg/exact/mesh_cache.hpp"
#include "csg/exact/walk.hpp"
#include "rt_core/api/error.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::csg {

namespace {

/// A convex solid: its corners.
using Part = std::vector<Vec3d>;

/// A solid as meshes whose union it is.
using Operand = std::vector<TriangleMesh>;

Operand operand(const SolidTree& tree, std::uint32_t node, double tolerance) {
    Operand out;
    for (const std::uint32_t part : united_parts(tree, node)) out.push_back(evaluate_mesh(tree, part, tolerance));
    return out;
}

std::vector<Part> parts_of(const Operand& solid) {
    std::vector<Part> out;
    for (const TriangleMesh& mesh : solid)
        for (Part& corners : convex_parts(mesh))
            if (!corners.empty()) out.push_back(std::move(corners));
    return out;
}

double corner_count(const std::vector<Part>& parts) {
    double n = 0;
    for (const Part& part : parts) n += static_cast<double>(part.size());
    return n;
}

/// The hull of all sums of corners.
TriangleMesh sum(const Part& a, const Part& b) {
    std::vector<Vec3d> sums;
    sums.reserve(a.size() * b.size());
    for (const Vec3d p : a)
        for (const Vec3d q : b) sums.push_back(p + q);
    return convex_hull(sums);
}

void check_size(const std::vector<Part>& a, const std::vector<Part>& b) {
    const double points = corner_count(a) * corner_count(b);
    if (points > most_minkowski_points)
        throw Error(ErrorCode::limit, fmt::format("minkowski() of {} and {} convex parts would add "
                                                  "{:.0f} pairs of corners, wanted at most "
                                                  "{:.0f}: fewer facets ($fn) are needed",
                                                  a.size(), b.size(), points, most_minkowski_points));
}

std::vector<TriangleMesh> sum_of_all(const std::vector<Operand>& operands) {
    if (operands.size() == 1) return operands[0];
    std::vector<Part> so_far = parts_of(operands[0]);
    std::vector<TriangleMesh> out;
    for (std::size_t i = 1; i < operands.size(); ++i) {
        const std::vector<Part> next = parts_of(operands[i]);
        check_size(so_far, next);
        out.assign(so_far.size() * next.size(), {});
        parallel_for(static_cast<std::int64_t>(out.size()), [&](std::int64_t k) {
            const auto pair = static_cast<std::size_t>(k);
            out[pair] = sum(so_far[pair / next.size()], next[pair % next.size()]);
        });
        so_far.clear();
        for (const TriangleMesh& mesh : out) so_far.push_back(mesh.vertices);
    }
    return out;
}

}  // namespace

std::vector<TriangleMesh> minkowski(const SolidTree& tree, const std::vector<std::uint32_t>& nodes, double tolerance) {
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
    return cached(key, [&] { return sum_of_all(operands); });
}

}  // namespace cardioid::csg

#include "csg/exact/boolean/mesh_boolean.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>

#include "csg/exact/boolean/corefine.hpp"
#include "csg/exact/boolean/exact_data.hpp"
#include "csg/exact/hull.hpp"

namespace cardioid::csg {

namespace {

/// What parts that are empty or out of reach leave to do; false where the result is empty.
bool drop_idle(SolidOp op, std::vector<ExactSolid>& parts) {
    const auto is_empty = [](const ExactSolid& part) { return part.empty(); };
    if (parts.empty() || (op == SolidOp::subtract && is_empty(parts[0]))) return false;
    if (op == SolidOp::intersect && std::ranges::any_of(parts, is_empty)) return false;
    std::erase_if(parts, is_empty);
    if (op == SolidOp::subtract) {
        const Box3d whole = parts[0].bounds();
        std::erase_if(parts, [&](const ExactSolid& part) { return !part.bounds().overlaps(whole); });
    }
    return !parts.empty();
}

/// The parts as meshes where many are convex and as they were given. Cutting one after the other with all of the next
/// takes ever longer numbers, which planes alone do not need; that result is rounded, so it is not for a few.
std::vector<TriangleMesh> many_convex(SolidOp op, const std::vector<ExactSolid>& parts) {
    constexpr std::size_t most_triangles = 4000, many = 8;
    if (op != SolidOp::intersect || parts.size() < many) return {};
    if (!std::ranges::all_of(parts, &ExactSolid::is_plain)) return {};
    std::vector<TriangleMesh> out;
    std::size_t triangles = 0;
    for (const ExactSolid& part : parts) {
        out.push_back(part.rounded());
        triangles += out.back().triangles.size();
        if (triangles > most_triangles || !is_convex(out.back())) return {};
    }
    return out;
}

/// Parts by the groups whose boxes hang together: no part touches one of another group.
std::vector<std::vector<ExactSolid>> groups_in_reach(const std::vector<ExactSolid>& parts) {
    std::vector<std::size_t> order(parts.size()), parent(parts.size());
    std::iota(order.begin(), order.end(), 0U);
    std::iota(parent.begin(), parent.end(), 0U);
    std::ranges::sort(order, {}, [&](std::size_t i) { return parts[i].bounds().lo.x; });
    const auto root = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    std::vector<std::size_t> open;  // what the sweep along x is within
    for (const std::size_t i : order) {
        const Box3d box = parts[i].bounds();
        std::erase_if(open, [&](std::size_t j) { return parts[j].bounds().hi.x < box.lo.x; });
        for (const std::size_t j : open)
            if (box.overlaps(parts[j].bounds())) parent[root(j)] = root(i);
        open.push_back(i);
    }
    std::map<std::size_t, std::vector<ExactSolid>> groups;
    for (std::size_t i = 0; i < parts.size(); ++i) groups[root(i)].push_back(parts[i]);
    std::vector<std::vector<ExactSolid>> out;
    for (auto& [first, group] : groups) out.push_back(std::move(group));
    return out;
}

/// Solids that do not touch, as one.
ExactSolid side_by_side(const std::vector<ExactSolid>& solids) {
    auto out = std::make_shared<ExactData>();
    out->sound = out->plain = true;
    for (const ExactSolid& solid : solids) {
        if (solid.empty()) continue;
        const auto first = static_cast<std::uint32_t>(out->points.size());
        const ExactData& data = solid.data();
        out->points.insert(out->points.end(), data.points.begin(), data.points.end());
        for (const auto& [a, b, c] : data.triangles) out->triangles.push_back({a + first, b + first, c + first});
        out->sound = out->sound && data.sound;
        out->plain = out->plain && data.plain;
    }
    if (out->triangles.empty()) return {};
    out->settle();
    return ExactSolid(std::move(out));
}

/// The boolean of parts in each other's reach.
ExactSolid join(SolidOp op, std::vector<ExactSolid> parts) {
    if (parts.size() == 1) return std::move(parts[0]);
    if (auto quick = corefine(op, parts)) return std::move(*quick);
    static std::mutex one_at_a_time;  // Nef polyhedra need a gigabyte where they are needed, and promise no threads
    const std::lock_guard lock(one_at_a_time);
    return nef_boolean(op, parts);
}

}  // namespace

ExactSolid mesh_boolean(SolidOp op, std::vector<ExactSolid> parts) {
    if (!drop_idle(op, parts)) return {};
    if (parts.size() == 1) return std::move(parts[0]);
    if (const std::vector<TriangleMesh> convex = many_convex(op, parts); !convex.empty())
        return ExactSolid(convex_intersection(convex));
    if (op != SolidOp::unite) return join(op, std::move(parts));
    std::vector<ExactSolid> solids;
    for (std::vector<ExactSolid>& group : groups_in_reach(parts)) solids.push_back(join(op, std::move(group)));
    return solids.size() == 1 ? std::move(solids[0]) : side_by_side(solids);
}

}  // namespace cardioid::csg

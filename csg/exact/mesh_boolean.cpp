#include "csg/exact/mesh_boolean.hpp"

#include <algorithm>
#include <mutex>

#include "csg/exact/corefine.hpp"
#include "csg/exact/hull.hpp"
#include "csg/exact/mesh_cache.hpp"

namespace cardioid::csg {

namespace {

/// What empty parts leave to do; false where the result is empty.
bool drop_empty(SolidOp op, std::vector<TriangleMesh>& parts) {
    const auto is_empty = [](const TriangleMesh& mesh) { return mesh.triangles.empty(); };
    if (parts.empty() || (op == SolidOp::subtract && is_empty(parts[0]))) return false;
    if (op == SolidOp::intersect && std::ranges::any_of(parts, is_empty)) return false;
    std::erase_if(parts, is_empty);
    return !parts.empty();
}

/// Cutting one after the other with all of the next takes ever longer numbers, which planes alone do not need.
bool is_many_convex(SolidOp op, const std::vector<TriangleMesh>& parts) {
    constexpr std::size_t most_triangles = 4000;
    if (op != SolidOp::intersect || parts.size() < 3) return false;
    std::size_t triangles = 0;
    for (const TriangleMesh& part : parts) triangles += part.triangles.size();
    return triangles <= most_triangles && std::ranges::all_of(parts, is_convex);
}

TriangleMesh combine(SolidOp op, const std::vector<TriangleMesh>& parts) {
    if (is_many_convex(op, parts)) return convex_intersection(parts);
    if (auto quick = corefine(op, parts)) return std::move(*quick);
    static std::mutex one_at_a_time;  // Nef polyhedra need a gigabyte where they are needed, and promise no threads
    const std::lock_guard lock(one_at_a_time);
    return nef_boolean(op, parts);
}

}  // namespace

TriangleMesh mesh_boolean(SolidOp op, std::vector<TriangleMesh> parts) {
    if (!drop_empty(op, parts)) return {};
    if (parts.size() == 1) return std::move(parts[0]);
    ContentHash key;
    key.add(static_cast<std::uint64_t>(op));
    for (const TriangleMesh& part : parts) key.add(part);
    return std::move(cached(key, [&] { return std::vector{combine(op, parts)}; })[0]);
}

}  // namespace cardioid::csg

#include "csg/exact/mesh_boolean.hpp"

#include <algorithm>

#include "csg/exact/corefine.hpp"
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

TriangleMesh combine(SolidOp op, const std::vector<TriangleMesh>& parts) {
    if (auto quick = corefine(op, parts)) return std::move(*quick);
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

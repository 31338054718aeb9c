#include <algorithm>
#include <cmath>

#include "csg/exact/hull.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "formats/brlcad/scene/solids.hpp"

namespace cardioid::formats::brlcad {

namespace {

/// Corners nearer to each other than this share of the solid's size are one: single precision leaves them apart.
constexpr double same_corner = 1e-7;
/// Components of an edge below this share of it are rounding.
constexpr double rounding = 1e-13;
/// Corners of an arbn are looked for at every three of its planes.
constexpr std::size_t most_planes = 100;

using Node = std::optional<std::uint32_t>;

/// An edge along an axis as exactly that, so that the quickest solver may take it.
Vec3d straightened(Vec3d v) {
    const double least = rounding * length(v);
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(v[axis]) < least) v[axis] = 0;
    return v;
}

/// The map of the unit cube onto the corners where they are a parallelepiped.
std::optional<Affine> as_box(const std::array<Vec3d, 8>& p, double slack) {
    const Vec3d x = p[1] - p[0], y = p[3] - p[0], z = p[4] - p[0];
    const auto near = [&](Vec3d a, Vec3d b) { return length(a - b) <= slack; };
    if (!near(p[2], p[0] + x + y) || !near(p[5], p[0] + x + z) || !near(p[7], p[0] + y + z) ||
        !near(p[6], p[0] + x + y + z))
        return std::nullopt;
    return columns(straightened(x), straightened(y), straightened(z), p[0]);
}

/// Where three planes n.p = d meet.
std::optional<Vec3d> meeting(const double* a, const double* b, const double* c) {
    const Vec3d na{a[0], a[1], a[2]}, nb{b[0], b[1], b[2]}, nc{c[0], c[1], c[2]};
    const double det = dot(na, cross(nb, nc));
    if (std::abs(det) <= 1e-9 * length(na) * length(nb) * length(nc)) return std::nullopt;
    return (cross(nb, nc) * a[3] + cross(nc, na) * b[3] + cross(na, nb) * c[3]) * (1 / det);
}

/// Plates as slabs on the triangles: to both sides, or inward from them.
Node add_plates(SolidTarget& target, const Solid& solid) {
    const std::uint32_t triangle = target.tree.add_profile({{{{0, 0}, {1, 0}, {0, 1}}}});
    const auto corner = [&](std::size_t i) {
        const double* p = &solid.numbers[3 * std::size_t{solid.corners[i]}];
        return Vec3d{p[0], p[1], p[2]};
    };
    std::vector<std::uint32_t> parts;
    for (std::size_t i = 0; i + 2 < solid.corners.size(); i += 3) {
        const Vec3d a = corner(i), b = corner(i + 1), c = corner(i + 2);
        Vec3d n = cross(b - a, c - a);
        const double thickness = i / 3 < solid.thickness.size() ? solid.thickness[i / 3] : 0, size = length(n);
        if (!(thickness > 0 && size > 0)) continue;
        n *= thickness / size * (solid.orientation == 3 ? -1 : 1);
        const bool appended = i / 3 < solid.appended.size() && solid.appended[i / 3];
        const Vec3d from = appended ? a - n : a - n * 0.5;
        if (const Node part = add_leaf(
                target,
                {.kind = LeafKind::prism, .to_world = columns(b - a, c - a, n, from), .a = 1, .data = triangle}))
            parts.push_back(*part);
    }
    target.note.clear();  // of triangles without area
    if (parts.empty()) target.note = "is of plates of which none has a thickness, and is left out";
    return parts.empty() ? Node{} : target.tree.add_node(SolidOp::unite, parts);
}

}  // namespace

std::optional<std::uint32_t> add_mesh(SolidTarget& target, TriangleMesh mesh) {
    if (mesh.triangles.empty()) {
        target.note = "has no volume";
        return std::nullopt;
    }
    return add_leaf(target, {.kind = LeafKind::mesh, .data = target.tree.add_mesh(std::move(mesh))});
}

std::optional<std::uint32_t> add_ars(SolidTarget& target, const Solid& solid) {
    TriangleMesh mesh;
    const auto& v = solid.numbers;
    for (std::size_t i = 0; i + 2 < v.size(); i += 3) mesh.vertices.push_back({v[i], v[i + 1], v[i + 2]});
    const std::size_t around = solid.points_a_curve, curves = around ? mesh.vertices.size() / around : 0;
    const auto at = [&](std::size_t i, std::size_t k) { return static_cast<std::uint32_t>(i * around + k % around); };
    for (std::size_t i = 0; i + 1 < curves; ++i)
        for (std::size_t k = 0; k < around; ++k) {
            mesh.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
            mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
        }
    if (!csg::repair(mesh).closed()) target.note = "is not closed, and is drawn as a surface";
    return add_mesh(target, std::move(mesh));
}

std::optional<std::uint32_t> add_arb8(SolidTarget& target, const Solid& solid) {
    std::array<Vec3d, 8> p;
    Box3d box;
    for (std::size_t i = 0; i < 8; ++i) {
        p[i] = {solid.numbers[3 * i], solid.numbers[3 * i + 1], solid.numbers[3 * i + 2]};
        box.include(p[i]);
    }
    const double slack = same_corner * box.diagonal();
    if (const auto map = as_box(p, slack)) return add_leaf(target, {.kind = LeafKind::box, .to_world = *map});
    for (std::size_t i = 1; i < 8; ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (length(p[i] - p[k]) <= slack) p[i] = p[k];
    static constexpr std::uint32_t quads[6][4] = {{3, 2, 1, 0}, {4, 5, 6, 7}, {4, 7, 3, 0},
                                                  {2, 6, 5, 1}, {1, 5, 4, 0}, {7, 6, 2, 3}};
    TriangleMesh mesh;
    mesh.vertices.assign(p.begin(), p.end());
    for (const auto& [a, b, c, d] : quads) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    }
    if (!csg::repair(mesh).closed()) target.note = "has faces that do not close, and is drawn as a surface";
    if (!(std::abs(csg::volume(mesh)) > 1e-12 * std::pow(box.diagonal(), 3))) {
        target.note = "has no volume";
        return std::nullopt;
    }
    return add_mesh(target, std::move(mesh));
}

std::optional<std::uint32_t> add_arbn(SolidTarget& target, const Solid& solid) {
    const auto& v = solid.numbers;
    const std::size_t planes = v.size() / 4;
    if (planes > most_planes) {
        target.note = "has more than 100 planes, and is left out";
        return std::nullopt;
    }
    double reach = 0;
    for (std::size_t i = 0; i < planes; ++i) reach = std::max(reach, std::abs(v[4 * i + 3]));
    const auto inside = [&](Vec3d p) {
        for (std::size_t i = 0; i < planes; ++i)
            if (v[4 * i] * p.x + v[4 * i + 1] * p.y + v[4 * i + 2] * p.z > v[4 * i + 3] + 1e-9 * reach) return false;
        return true;
    };
    std::vector<Vec3d> corners;
    for (std::size_t i = 0; i < planes; ++i)
        for (std::size_t j = 0; j < i; ++j)
            for (std::size_t k = 0; k < j; ++k)
                if (const auto p = meeting(&v[4 * i], &v[4 * j], &v[4 * k]); p && inside(*p)) corners.push_back(*p);
    return add_mesh(target, corners.size() < 4 ? TriangleMesh{} : csg::convex_hull(corners));
}

std::optional<std::uint32_t> add_bot(SolidTarget& target, const Solid& solid) {
    if (solid.mode > 2) return add_plates(target, solid);
    TriangleMesh mesh;
    for (std::size_t i = 0; i + 2 < solid.numbers.size(); i += 3)
        mesh.vertices.push_back({solid.numbers[i], solid.numbers[i + 1], solid.numbers[i + 2]});
    for (std::size_t i = 0; i + 2 < solid.corners.size(); i += 3)
        mesh.triangles.push_back({solid.corners[i], solid.corners[i + 1], solid.corners[i + 2]});
    if (solid.orientation == 3)
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    const csg::MeshFaults faults = csg::repair(mesh);
    if (!faults.closed()) target.note = "is not closed, and is drawn as a surface";
    return add_mesh(target, std::move(mesh));
}

}  // namespace cardioid::formats::brlcad

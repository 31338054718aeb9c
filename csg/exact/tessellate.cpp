#include "csg/exact/tessellate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "csg/exact/form_mesh.hpp"
#include "csg/exact/walk.hpp"
#include "csg/shapes/degrees.hpp"
#include "csg/shapes/extrude.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::csg {

namespace {

constexpr int fewest_corners = 12, most_corners = 720;
/// A curve's share of its size that a box around it may miss.
constexpr double box_share = 1e-4;

TriangleMesh unit_box() {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) mesh.vertices.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
    constexpr std::uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& [a, b, c, d] : quads) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    }
    return mesh;
}

/// A ball with corners at its poles, so that its box is that of the sphere.
TriangleMesh unit_ball(int n) {
    TriangleMesh mesh;
    const int rings = n / 2;
    const auto corners = static_cast<std::uint32_t>(n);
    mesh.vertices.push_back({0, 0, 1});
    for (int i = 1; i < rings; ++i) {
        const auto [s, c] = sin_cos_deg(180.0 * i / rings);
        for (const Vec2d p : circle_points(s, n)) mesh.vertices.push_back({p.x, p.y, c});
    }
    mesh.vertices.push_back({0, 0, -1});
    const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    for (std::uint32_t k = 0; k < corners; ++k) {
        const std::uint32_t next = (k + 1) % corners;
        mesh.triangles.push_back({0, 1 + k, 1 + next});
        for (std::uint32_t i = 0; i + 2 < static_cast<std::uint32_t>(rings); ++i) {
            const std::uint32_t upper = 1 + i * corners, lower = upper + corners;
            mesh.triangles.push_back({upper + k, lower + k, lower + next});
            mesh.triangles.push_back({upper + k, lower + next, upper + next});
        }
        const std::uint32_t ring = last - corners;
        mesh.triangles.push_back({last, ring + next, ring + k});
    }
    return mesh;
}

TriangleMesh ring_of_tube(double ring, double tube, double tolerance, double scale) {
    const int around = fine_corners((ring + tube) * scale, tolerance), n = fine_corners(tube * scale, tolerance);
    std::vector<Vec2d> circle = circle_points(tube, n);
    for (Vec2d& p : circle) p.x += ring;
    return rotate_extrude({{std::move(circle)}}, 360, {.fn = double(around)});
}

double greatest_radius(const Profile& profile) {
    double out = 0;
    for (const auto& contour : profile.contours)
        for (const Vec2d p : contour) out = std::max(out, std::abs(p.x));
    return out;
}

/// The greatest length the map gives a unit vector, or a little more.
double stretch(const Affine& m) {
    double squares = 0;
    for (int i = 0; i < 3; ++i) squares = std::max(squares, dot(m.column(i), m.column(i)));
    return std::sqrt(squares);
}

/// The same of unit vectors across the axis: equal radii get equal corners whatever the heights.
double stretch_across(const Affine& m) {
    return std::sqrt(std::max(dot(m.column(0), m.column(0)), dot(m.column(1), m.column(1))));
}

TriangleMesh in_own_space(const SolidTree& tree, const Leaf& leaf, double tolerance) {
    const double scale = stretch(leaf.to_world), across = stretch_across(leaf.to_world);
    switch (leaf.kind) {
        case LeafKind::box:
            return unit_box();
        case LeafKind::sphere:
            return unit_ball(fine_corners(scale, tolerance / 2));  // two chords cross: each may miss half of it
        case LeafKind::cone:
            return faceted_cone(1, leaf.a, leaf.b, fine_corners(std::max(leaf.a, leaf.b) * across, tolerance));
        case LeafKind::torus:
            return ring_of_tube(leaf.a, leaf.b, tolerance / 2, scale);
        case LeafKind::prism:
            return linear_extrude(*tree.profiles[leaf.data], {.height = 1, .scale = {leaf.a, leaf.a}});
        case LeafKind::revolution: {
            const Profile& profile = *tree.profiles[leaf.data];
            const int n = fine_corners(greatest_radius(profile) * across, tolerance);
            return rotate_extrude(profile, 360, {.fn = double(n)});
        }
        case LeafKind::form: {
            const int n = fine_corners(2 * scale, tolerance / 2);
            return form_mesh(tree.forms[leaf.data], n, unit_ball(n));
        }
        case LeafKind::mesh:
            return *tree.meshes[leaf.data];
        case LeafKind::half_space:
            break;
    }
    throw Error(ErrorCode::bad_input, "a half space has no end, so no mesh can stand for it");
}

/// Half the size of a unit disc's image along an axis, its plane spanned by the columns u and v of the map.
double disc_reach(const Affine& m, int axis) {
    const Vec3d row = m.row[static_cast<std::size_t>(axis)];
    return std::hypot(row.x, row.y);
}

Box3d ball_bounds(const Affine& m) {
    const Vec3d reach{length(m.row[0]), length(m.row[1]), length(m.row[2])};
    return {m.t - reach, m.t + reach};
}

Box3d cone_bounds(const Leaf& leaf) {
    Box3d out;
    const Affine& m = leaf.to_world;
    for (const auto& [z, r] : {std::pair{0.0, leaf.a}, {1.0, leaf.b}}) {
        const Vec3d centre = m.point({0, 0, z});
        const Vec3d reach = Vec3d{disc_reach(m, 0), disc_reach(m, 1), disc_reach(m, 2)} * r;
        out.include(Box3d{centre - reach, centre + reach});
    }
    return out;
}

}  // namespace

int fine_corners(double r, double tolerance) {
    if (!(tolerance > 0) || !(r > 0)) return most_corners;
    const double cosine = std::max(1 - tolerance / r, 0.5);
    const double n = std::numbers::pi / std::acos(cosine);
    const double fours = 4 * std::ceil(std::min(n, double(most_corners)) / 4);
    return std::clamp(static_cast<int>(fours), fewest_corners, most_corners);
}

TriangleMesh tessellate(const SolidTree& tree, const Leaf& leaf, double tolerance) {
    TriangleMesh mesh = in_own_space(tree, leaf, tolerance);
    for (Vec3d& v : mesh.vertices) v = leaf.to_world.point(v);
    if (leaf.to_world.determinant() < 0)
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    weld(mesh);
    return mesh;
}

Box3d tight_bounds(const SolidTree& tree, const Leaf& leaf) {
    if (leaf.kind == LeafKind::half_space) return Box3d::everything();
    if (leaf.kind == LeafKind::sphere) return ball_bounds(leaf.to_world);
    if (leaf.kind == LeafKind::cone) return cone_bounds(leaf);
    Box3d out;
    if (leaf.kind == LeafKind::mesh) {
        for (const auto& t : tree.meshes[leaf.data]->triangles)
            for (const std::uint32_t v : t) out.include(leaf.to_world.point(tree.meshes[leaf.data]->vertices[v]));
        return out;
    }
    for (const Vec3d v : tessellate(tree, leaf, box_share * stretch(leaf.to_world)).vertices) out.include(v);
    return out;
}

Box3d tight_bounds(const SolidTree& tree, std::uint32_t node) {
    Box3d out;
    for_each_leaf(tree, node, [&](const Leaf& leaf) { out.include(tight_bounds(tree, leaf)); });
    return out;
}

}  // namespace cardioid::csg

#include "formats/brlcad/scene/charts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/brlcad/look/uv_chart.hpp"
#include "formats/brlcad/scene/solids.hpp"

namespace cardioid::formats::brlcad {

namespace {

using Kind = UvChart::Kind;
using Numbers = std::vector<double>;

Vec3d vector(const Solid& solid, std::size_t i) {
    return {solid.numbers[i], solid.numbers[i + 1], solid.numbers[i + 2]};
}

void append(Numbers& out, Vec3d v) { out.insert(out.end(), {v.x, v.y, v.z}); }

Numbers mapped(Kind kind, const Affine& to_world) {
    if (!(std::abs(to_world.determinant()) > 0)) return {0};
    const Affine local = to_world.inverse();
    Numbers out{static_cast<double>(kind)};
    for (const Vec3d& row : local.row) append(out, row);
    append(out, local.t);
    return out;
}

Numbers tube(const Solid& solid, const Affine& place) {
    Vec3d v = vector(solid, 0), h = vector(solid, 3);
    std::array<Vec3d, 4> axes{vector(solid, 6), vector(solid, 9), vector(solid, 12), vector(solid, 15)};
    if (length(axes[0]) * length(axes[1]) < length(axes[2]) * length(axes[3])) {
        v += h, h = -h;
        std::swap(axes[0], axes[2]), std::swap(axes[1], axes[3]);
    }
    Numbers out = mapped(Kind::tube, place * columns(axes[0], axes[1], h, v));
    if (out.size() > 1) out.insert(out.end(), {length(axes[2]) / length(axes[0]), length(axes[3]) / length(axes[1])});
    return out;
}

/// Perpendicular to v, without the smallest of its components (bn_vec_ortho).
Vec3d aside(Vec3d v) {
    int least = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(v[axis]) < std::abs(v[least])) least = axis;
    Vec3d out;
    out[(least + 1) % 3] = -v[(least + 2) % 3];
    out[(least + 2) % 3] = v[(least + 1) % 3];
    return normalize(out);
}

Numbers ring(const Solid& solid, const Affine& place) {
    const Vec3d axis = normalize(vector(solid, 3)), a = aside(axis), b = cross(axis, a);
    const double r = solid.numbers[6];
    return mapped(Kind::ring, place * columns(a * r, b * r, axis * r, vector(solid, 0)));
}

/// The base of rt_hlf_prep: across the axis that the normal has least of.
Numbers plane(const Solid& solid, const Affine& place) {
    const Vec3d n = normalize(place.vector(vector(solid, 0)));
    const Vec3d at = place.point(vector(solid, 0) * (solid.numbers[3] / dot(vector(solid, 0), vector(solid, 0))));
    int least = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(n[axis]) < std::abs(n[least])) least = axis;
    Vec3d other;
    other[least] = 1;
    const Vec3d x = normalize(cross(other, n));
    Numbers out{static_cast<double>(Kind::plane)};
    for (const Vec3d& v : {n * dot(n, at), x, normalize(cross(x, n))}) append(out, v);
    return out;
}

/// Moves the origin and the length along one direction so that every corner is within.
void cover(Vec3d point, Vec3d direction, Vec3d& origin, double& size) {
    const double f = dot(point - origin, direction);
    if (f > size) size = f;
    if (f < 0) origin += direction * f, size -= f;
}

/// One face as rt_arb_add_pt makes it: u along its first edge, v away from it, both over all of the face.
void face(std::vector<Vec3d> p, Numbers& out) {
    std::vector<Vec3d> distinct;
    for (const Vec3d& q : p)
        if (std::none_of(distinct.begin(), distinct.end(), [&](Vec3d r) { return length(q - r) < 0.0005; }))
            distinct.push_back(q);
    if (distinct.size() < 3) return;
    Vec3d origin = distinct[0];
    const Vec3d u = normalize(distinct[1] - origin), third = distinct[2] - origin;
    double width = length(distinct[1] - origin);
    const Vec3d away = third - u * dot(third, u);
    if (!(length(away) > 0)) return;
    const Vec3d v = normalize(away), n = cross(u, v);
    double height = length(away);
    cover(distinct[2], u, origin, width);
    if (distinct.size() > 3) {
        cover(distinct[3], u, origin, width);
        cover(distinct[3], v, origin, height);
    }
    for (const Vec3d& w : {n, origin, u * (1 / width), v * (1 / height)}) append(out, w);
}

Numbers faces(const Solid& solid, const Affine& place) {
    static constexpr std::array<std::array<std::size_t, 4>, 6> corners{
        {{3, 2, 1, 0}, {4, 5, 6, 7}, {4, 7, 3, 0}, {2, 6, 5, 1}, {1, 5, 4, 0}, {7, 6, 2, 3}}};
    Numbers out{static_cast<double>(Kind::faces)};
    for (const auto& four : corners) {
        std::vector<Vec3d> p;
        for (const std::size_t i : four) p.push_back(place.point(vector(solid, 3 * i)));
        face(std::move(p), out);
    }
    return out;
}

}  // namespace

std::vector<double> chart_of(const Solid& solid, const Affine& place) {
    Numbers out{0};
    if (solid.kind == SolidKind::ell)
        out =
            mapped(Kind::ball, place * columns(vector(solid, 3), vector(solid, 6), vector(solid, 9), vector(solid, 0)));
    if (solid.kind == SolidKind::tgc) out = tube(solid, place);
    if (solid.kind == SolidKind::tor) out = ring(solid, place);
    if (solid.kind == SolidKind::half) out = plane(solid, place);
    if (solid.kind == SolidKind::arb8) out = faces(solid, place);
    const bool finite = std::all_of(out.begin(), out.end(), [](double x) { return std::isfinite(x); });
    return finite ? out : Numbers{0};
}

}  // namespace cardioid::formats::brlcad

#include "formats/openscad/geometry/transforms.hpp"

#include <algorithm>
#include <cmath>

#include "csg/shapes/degrees.hpp"

namespace cardioid::formats::openscad {
namespace {

Affine rotation_x(double degrees) {
    const auto [s, c] = csg::sin_cos_deg(degrees);
    return {{Vec3d{1, 0, 0}, {0, c, -s}, {0, s, c}}, {}};
}

Affine rotation_y(double degrees) {
    const auto [s, c] = csg::sin_cos_deg(degrees);
    return {{Vec3d{c, 0, s}, {0, 1, 0}, {-s, 0, c}}, {}};
}

/// Rodrigues' formula; the identity for an axis of no length.
Affine rotation_about(Vec3d axis, double degrees) {
    const double size = length(axis);
    if (!(size > 0)) return {};
    const Vec3d u = axis / size;
    const auto [s, c] = csg::sin_cos_deg(degrees);
    Affine out;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) out.row[static_cast<std::size_t>(i)][j] = (1 - c) * u[i] * u[j] + (i == j ? c : 0);
    out.row[0].y -= s * u.z, out.row[0].z += s * u.y;
    out.row[1].x += s * u.z, out.row[1].z -= s * u.x;
    out.row[2].x -= s * u.y, out.row[2].y += s * u.x;
    return out;
}

/// What a rotation by an infinite angle comes to: OpenSCAD removes the object.
Affine not_finite() { return Affine::translation({NAN, NAN, NAN}); }

Affine rotation(const Arguments& args) {
    if (args.is("a", ValueKind::numbers)) {
        const Vec3d a = args.vector("a").value_or(Vec3d{});
        return is_finite(a) ? rotation_z(a.z) * rotation_y(a.y) * rotation_x(a.x) : not_finite();
    }
    const double a = args.number("a", 0);
    const Vec3d axis = args.vector("v").value_or(Vec3d{0, 0, 1});
    if (!std::isfinite(a) || !is_finite(axis)) return not_finite();
    return axis.x == 0 && axis.y == 0 && axis.z > 0 ? rotation_z(a) : rotation_about(axis, a);
}

Affine mirroring(const Arguments& args) {
    const Vec3d v = args.vector("v").value_or(Vec3d{1, 0, 0});
    const double size = length(v);
    if (size == 0) return {};
    const Vec3d u = v / size;
    Affine out;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) out.row[static_cast<std::size_t>(i)][j] -= 2 * u[i] * u[j];
    return out;
}

/// Entries that are missing are those of the identity; the last row divides, as in OpenSCAD.
Affine matrix(const Arguments& args) {
    const Value* m = args.value("m");
    if (!m) return {};
    if (m->kind != ValueKind::list) args.wrong("m", "a list of 4 lists of 4 numbers");
    double entry[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    const auto rows = args.ast().values_of(*m);
    for (std::size_t i = 0; i < std::min<std::size_t>(rows.size(), 4); ++i) {
        if (rows[i].kind != ValueKind::numbers) args.wrong("m", "a list of 4 lists of 4 numbers");
        const auto xs = args.ast().numbers_of(rows[i]);
        for (std::size_t j = 0; j < std::min<std::size_t>(xs.size(), 4); ++j) entry[i][j] = xs[j];
    }
    const double w = entry[3][3];
    Affine out;
    for (std::size_t i = 0; i < 3; ++i) {
        out.row[i] = {entry[i][0] / w, entry[i][1] / w, entry[i][2] / w};
        out.t[static_cast<int>(i)] = entry[i][3] / w;
    }
    return out;
}

}  // namespace

Affine transform_of(Node node, const Arguments& args) {
    switch (node) {
        case Node::multmatrix:
            return matrix(args);
        case Node::translate:
            return Affine::translation(args.vector("v").value_or(Vec3d{}));
        case Node::rotate:
            return rotation(args);
        case Node::scale:
            return Affine::scaling(args.is("v", ValueKind::numbers) ? *args.vector("v", 1) : args.size("v", 1));
        case Node::mirror:
            return mirroring(args);
        default:
            return {};
    }
}

Affine in_plane(const Affine& m) {
    return {{Vec3d{m.row[0].x, m.row[0].y, 0}, {m.row[1].x, m.row[1].y, 0}, {0, 0, 1}}, {m.t.x, m.t.y, 0}};
}

bool is_singular(const Affine& m) {
    constexpr double flat = 1e-14;  // of the volume its rows could span: below it only rounding is left
    const double span = length(m.row[0]) * length(m.row[1]) * length(m.row[2]);
    return !is_finite(m.t) || !std::isfinite(span) || !(std::abs(m.determinant()) > flat * span);
}

bool is_out_of_reach(const Affine& m) {
    constexpr double reach = 1e15;  // what is seen from there stays well below Embree's 1.8e18
    return std::max({max_component(abs(m.t)), length(m.row[0]), length(m.row[1]), length(m.row[2])}) > reach;
}

Affine rotation_z(double degrees) {
    const auto [s, c] = csg::sin_cos_deg(degrees);
    return {{Vec3d{c, -s, 0}, {s, c, 0}, {0, 0, 1}}, {}};
}

Affine rotation_to(Vec3d n) {
    n = normalize(n);  // Duff et al. 2017, "Building an Orthonormal Basis, Revisited"
    const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
    const Vec3d s{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, t{b, sign + n.y * n.y * a, -n.y};
    return {{Vec3d{s.x, t.x, n.x}, {s.y, t.y, n.y}, {s.z, t.z, n.z}}, {}};
}

}  // namespace cardioid::formats::openscad

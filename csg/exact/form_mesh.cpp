#include "csg/exact/form_mesh.hpp"

#include <cmath>

#include "csg/leaves/forms.hpp"
#include "csg/shapes/degrees.hpp"
#include "csg/shapes/extrude.hpp"
#include "csg/shapes/facets.hpp"

namespace cardioid::csg {

namespace {

/// Distance from the axis of a bowl's or trough's wall at height z.
double wall(const Form& form, double z) {
    const double w = form.numbers[0], u = 1 - z;
    return std::sqrt(w * u * u + (1 - w) * u);
}

/// Half of a bowl's section, or all of a trough's, counter-clockwise from the axis or the left rim.
std::vector<Vec2d> bowl_section(const Form& form, int steps, bool both) {
    std::vector<Vec2d> points;
    if (!both) points.push_back({0, 0});
    // Even steps of the distance from the axis: the wall is steep at the rim and flat at the top.
    const auto height = [&](double r) {
        const double w = form.numbers[0], half = (1 - w) / 2;
        return 1 - (w > 0 ? (std::sqrt(half * half + w * r * r) - half) / w : r * r);
    };
    for (int i = 0; i <= steps; ++i) {
        const double r = 1 - static_cast<double>(i) / steps;
        points.push_back(r == 0 ? Vec2d{0, 1} : Vec2d{wall(form, i == 0 ? 0 : height(r)), i == 0 ? 0 : height(r)});
    }
    if (both)
        for (int i = steps; i-- > 0;) {
            const Vec2d p = points[static_cast<std::size_t>(i)];
            points.push_back({-p.x, p.y});
        }
    return points;
}

std::vector<Vec2d> waist_section(const Form& form, int steps) {
    std::vector<Vec2d> points{{0, -1}};
    const double n = form.numbers[0];
    for (int i = 0; i <= steps; ++i) {
        const double z = 2.0 * i / steps - 1;
        points.push_back({std::sqrt(n + (1 - n) * z * z), z});
    }
    points.push_back({0, 1});
    return points;
}

/// Points of the ellipse a x^2 + b x z + c z^2 = 1 around (R, 0): x = u / sqrt(a) and so on, after the square in z.
std::vector<Vec2d> ring_section(const Form& form, int steps) {
    const auto& [R, a, b, c] = form.numbers;
    const double across = std::sqrt(c - b * b / (4 * a));
    std::vector<Vec2d> points = circle_points(1, steps);
    for (Vec2d& p : points) {
        const double z = p.y / across;
        p = {R + p.x / std::sqrt(a) - b * z / (2 * a), z};
    }
    return points;
}

TriangleMesh turned(std::vector<Vec2d> section, int corners) {
    return rotate_extrude({{std::move(section)}}, 360, {.fn = double(corners)});
}

}  // namespace

TriangleMesh form_mesh(const Form& form, int corners, const TriangleMesh& ball) {
    const int steps = corners / 2;
    switch (form.kind) {
        case FormKind::bowl:
            return turned(bowl_section(form, steps, false), corners);
        case FormKind::waist:
            return turned(waist_section(form, steps), corners);
        case FormKind::tilted_ring:
            return turned(ring_section(form, corners), corners);
        case FormKind::trough: {
            TriangleMesh mesh = linear_extrude({{bowl_section(form, steps, true)}}, {.height = 1});
            // The section stands in x and z; what was the height lies along -y, from 1 down.
            for (Vec3d& v : mesh.vertices) v = {v.x, 1 - v.z, v.y};
            return mesh;
        }
        case FormKind::taper: {
            TriangleMesh mesh = faceted_cone(1, 1, 1, corners);
            for (Vec3d& v : mesh.vertices)
                if (v.z > 0) v.x *= form.numbers[0], v.y *= form.numbers[1];
            return mesh;
        }
        case FormKind::metaball:
            return blob_mesh(form, corners);
        case FormKind::superellipsoid:
            break;
    }
    TriangleMesh mesh = ball;
    for (Vec3d& v : mesh.vertices) v *= 1 / superellipsoid_norm(form, v);
    return mesh;
}

}  // namespace cardioid::csg

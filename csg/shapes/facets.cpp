#include "csg/shapes/facets.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "csg/shapes/degrees.hpp"
#include "csg/shapes/side_edges.hpp"

namespace cardioid::csg {

namespace {

/// OpenSCAD's GRID_FINE: the radius below which every circle is a triangle.
constexpr double smallest_radius = 0x1p-20;
/// OpenSCAD's F_MINIMUM for $fa and $fs.
constexpr double smallest_setting = 0.01;
/// More facets than memory holds anyway; keeps the conversion to int defined.
constexpr double most_facets = 1e9;

std::uint32_t index(std::size_t i) { return static_cast<std::uint32_t>(i); }

void append_ring(TriangleMesh& mesh, const std::vector<Vec2d>& ring, double z) {
    for (const Vec2d p : ring) mesh.vertices.push_back({p.x, p.y, z});
}

/// Quads between a ring of n corners that begins at `lower` and one above it that begins at `upper`.
void append_side(TriangleMesh& mesh, std::size_t lower, std::size_t upper, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t next = (k + 1) % n;
        mesh.triangles.push_back({index(upper + k), index(lower + k), index(lower + next)});
        mesh.triangles.push_back({index(upper + k), index(lower + next), index(upper + next)});
    }
}

/// Fills the ring of n corners that begins at `first`, seen from above or from below.
void append_disc(TriangleMesh& mesh, std::size_t first, std::size_t n, bool upwards) {
    for (std::size_t k = 1; k + 1 < n; ++k) {
        const std::uint32_t a = index(first + k), b = index(first + k + 1);
        mesh.triangles.push_back({index(first), upwards ? a : b, upwards ? b : a});
    }
}

/// Side triangles from a ring to an apex above (or below) it.
void append_fan(TriangleMesh& mesh, std::size_t ring, std::size_t apex, std::size_t n, bool apex_above) {
    for (std::size_t k = 0; k < n; ++k) {
        const std::uint32_t a = index(ring + k), b = index(ring + (k + 1) % n);
        mesh.triangles.push_back({index(apex), apex_above ? a : b, apex_above ? b : a});
    }
}

}  // namespace

int facet_count(double r, const FacetSettings& settings) {
    if (!(r >= smallest_radius) || !std::isfinite(settings.fn)) return 3;
    if (settings.fn > 0) return static_cast<int>(std::clamp(settings.fn, 3.0, most_facets));
    const double by_angle = 360 / std::max(smallest_setting, settings.fa);
    const double by_length = r * 2 * std::numbers::pi / std::max(smallest_setting, settings.fs);
    return static_cast<int>(std::ceil(std::clamp(std::min(by_angle, by_length), 5.0, most_facets)));
}

std::vector<Vec2d> circle_points(double r, int n) {
    std::vector<Vec2d> out;
    out.reserve(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) {
        const SinCos at = sin_cos_deg(360.0 * k / n);
        out.push_back({r * at.cos, r * at.sin});
    }
    return out;
}

TriangleMesh faceted_sphere(double r, int n) {
    const int rings = (n + 1) / 2;
    check_corner_count(static_cast<double>(rings) * n);
    const auto corners = static_cast<std::size_t>(n), count = static_cast<std::size_t>(rings);
    TriangleMesh mesh;
    mesh.vertices.reserve(corners * count);
    mesh.triangles.reserve(2 * corners * count);
    for (int i = 0; i < rings; ++i) {
        const SinCos polar = sin_cos_deg(180.0 * (i + 0.5) / rings);
        append_ring(mesh, circle_points(r * polar.sin, n), r * polar.cos);
    }
    append_disc(mesh, 0, corners, true);
    for (std::size_t i = 0; i + 1 < count; ++i) append_side(mesh, (i + 1) * corners, i * corners, corners);
    append_disc(mesh, (count - 1) * corners, corners, false);
    mesh.closed = true;
    return mesh;
}

TriangleMesh faceted_cone(double h, double r1, double r2, int n) {
    check_corner_count(2.0 * n);
    const auto corners = static_cast<std::size_t>(n);
    TriangleMesh mesh;
    if (r1 > 0) append_ring(mesh, circle_points(r1, n), 0);
    if (r1 <= 0) mesh.vertices.push_back({0, 0, 0});
    const std::size_t top = mesh.vertices.size();
    if (r2 > 0) append_ring(mesh, circle_points(r2, n), h);
    if (r2 <= 0) mesh.vertices.push_back({0, 0, h});
    if (r1 > 0) append_disc(mesh, 0, corners, false);
    if (r1 > 0 && r2 > 0) append_side(mesh, 0, top, corners);
    if (r1 > 0 && r2 <= 0) append_fan(mesh, 0, top, corners, true);
    if (r1 <= 0 && r2 > 0) append_fan(mesh, top, 0, corners, false);
    if (r2 > 0) append_disc(mesh, top, corners, true);
    mesh.closed = true;
    return mesh;
}

}  // namespace cardioid::csg

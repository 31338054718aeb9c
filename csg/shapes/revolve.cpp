#include <algorithm>
#include <cmath>

#include "csg/shapes/degrees.hpp"
#include "csg/shapes/extrude.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "csg/shapes/side_edges.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::csg {

namespace {

struct Reach {
    double left = 0, right = 0;  ///< least and greatest x, the axis included
};

Reach reach(const Profile& profile) {
    Reach out;
    for (const auto& contour : profile.contours)
        for (const Vec2d p : contour) out = {std::min(out.left, p.x), std::max(out.right, p.x)};
    return out;
}

/// Quads between two rings, run from `here` to `there`; corners on the axis make triangles of them once welded.
void append_wall(TriangleMesh& mesh, const std::vector<SideEdge>& edges, std::uint32_t here, std::uint32_t there,
                 bool against) {
    for (const SideEdge& edge : edges) {
        const std::uint32_t a = against ? edge.to : edge.from, b = against ? edge.from : edge.to;
        mesh.triangles.push_back({here + b, here + a, there + b});
        mesh.triangles.push_back({here + a, there + a, there + b});
    }
}

void append_ring(TriangleMesh& mesh, const FilledProfile& filled, const SinCos& at) {
    for (const Vec2d p : filled.points) mesh.vertices.push_back({p.x * at.cos, p.x * at.sin, p.y});
}

}  // namespace

TriangleMesh rotate_extrude(const Profile& profile, double angle_deg, const FacetSettings& facets) {
    TriangleMesh mesh;
    const double angle = angle_deg > -360 && angle_deg <= 360 ? angle_deg : 360;
    if (angle == 0 || profile.empty()) return mesh;
    const Reach sides = reach(profile);
    if (sides.left < 0 && sides.right > 0)
        throw Error(ErrorCode::bad_input, "the figure of rotate_extrude spans x = " + std::to_string(sides.left) +
                                              " to " + std::to_string(sides.right) + ", wanted one side of x = 0");
    const bool full = angle == 360;
    const int whole = facet_count(sides.right - sides.left, facets);
    const int steps = std::max(1, static_cast<int>(whole * std::abs(angle) / 360));
    const FilledProfile filled = fill(profile);
    const std::vector<SideEdge> edges = side_edges(filled);
    check_corner_count((steps + 1.0) * static_cast<double>(filled.points.size()));
    const auto ring = static_cast<std::uint32_t>(filled.points.size());
    const bool against = (full || angle < 0) != (sides.left < 0);  // rings run from a profile's back to its front
    for (int j = 0; j < steps + (full ? 0 : 1); ++j)
        append_ring(mesh, filled, sin_cos_deg(full ? 180 - 360.0 * j / steps : j * angle / steps));
    for (int j = 0; j < steps; ++j) {
        const auto next = static_cast<std::uint32_t>(full ? (j + 1) % steps : j + 1);
        append_wall(mesh, edges, static_cast<std::uint32_t>(j) * ring, next * ring, against);
    }
    if (!full) {
        append_cap(mesh, filled, 0, !against);
        append_cap(mesh, filled, static_cast<std::size_t>(steps) * ring, against);
    }
    weld(mesh);
    return mesh;
}

}  // namespace cardioid::csg

#include "csg/shapes/extrude.hpp"

#include <algorithm>
#include <cmath>

#include "csg/shapes/degrees.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "csg/shapes/side_edges.hpp"

namespace cardioid::csg {

namespace {

/// The figure as it is at height share t: turned clockwise, then scaled.
struct Section {
    SinCos turn;
    Vec2d scale;

    Section(const LinearExtrusion& how, int slice, int slices)
        : turn(sin_cos_deg(-how.twist_deg * slice / slices)),
          scale(1 - (1 - std::max(0.0, how.scale.x)) * slice / slices,
                1 - (1 - std::max(0.0, how.scale.y)) * slice / slices) {}

    [[nodiscard]] Vec2d operator()(Vec2d p) const {
        return {scale.x * (turn.cos * p.x - turn.sin * p.y), scale.y * (turn.sin * p.x + turn.cos * p.y)};
    }
    [[nodiscard]] bool collapses() const { return scale.x == 0 || scale.y == 0; }
};

/// -1, 0 or 1 as |a| is less than, within 10 ppm of, or greater than |b|.
int compare_lengths(Vec2d a, Vec2d b) {
    const double la = length(a), lb = length(b);
    if (2 * std::abs(la - lb) * 1e5 <= la + lb) return 0;
    return la < lb ? -1 : 1;
}

/// Side triangles of one slice between two sections. A quad is cut along the diagonal that is shorter seen from above;
/// of equal ones (edges in line with the axis) as its neighbours lean with the twist; at a top without area the other
/// way round, which leaves no thin ears (OpenSCAD 2021.01).
void append_slice(TriangleMesh& mesh, const FilledProfile& filled, const std::vector<SideEdge>& edges,
                  const Section& below, const Section& above, bool twists_back) {
    const auto upper = static_cast<std::uint32_t>(mesh.vertices.size() - filled.points.size());
    const auto lower = static_cast<std::uint32_t>(upper - filled.points.size());
    for (const SideEdge& edge : edges) {
        const Vec2d a = filled.points[edge.from], b = filled.points[edge.to];
        const int order = compare_lengths(below(a) - above(b), below(b) - above(a));
        const bool flip = edge.outer == twists_back;
        const bool rising = (order < 0 || (order == 0 && !flip)) != above.collapses();
        const std::uint32_t a1 = lower + edge.from, b1 = lower + edge.to, a2 = upper + edge.from, b2 = upper + edge.to;
        if (rising) {
            mesh.triangles.push_back({a1, b1, b2});
            mesh.triangles.push_back({a1, b2, a2});
        } else {
            mesh.triangles.push_back({a1, b1, a2});
            mesh.triangles.push_back({b1, b2, a2});
        }
    }
}

void append_section(TriangleMesh& mesh, const FilledProfile& filled, const Section& section, double z) {
    for (const Vec2d p : filled.points) {
        const Vec2d q = section(p);
        mesh.vertices.push_back({q.x, q.y, z});
    }
}

}  // namespace

TriangleMesh linear_extrude(const Profile& profile, const LinearExtrusion& how) {
    TriangleMesh mesh;
    if (!(how.height > 0) || !std::isfinite(how.height) || profile.empty()) return mesh;
    const FilledProfile filled = fill(profile);
    const std::vector<SideEdge> edges = side_edges(filled);
    const int slices = slice_count(profile, how);
    check_corner_count((slices + 1.0) * static_cast<double>(filled.points.size()));
    const double bottom = how.centre ? -how.height / 2 : 0, top = how.centre ? how.height / 2 : how.height;
    Section below(how, 0, slices);
    append_section(mesh, filled, below, bottom);
    append_cap(mesh, filled, 0, false);
    for (int j = 1; j <= slices; ++j) {
        const Section above(how, j, slices);
        append_section(mesh, filled, above, bottom + (top - bottom) * j / slices);
        append_slice(mesh, filled, edges, below, above, how.twist_deg <= 0);
        below = above;
    }
    append_cap(mesh, filled, mesh.vertices.size() - filled.points.size(), true);
    weld(mesh);
    return mesh;
}

}  // namespace cardioid::csg

#include "csg/exact/hull.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>
#include <algorithm>
#include <cmath>

#include "csg/shapes/mesh_edges.hpp"
#include "csg/shapes/mesh_repair.hpp"

namespace cardioid::csg {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

std::vector<Point> distinct(std::span<const Vec3d> points) {
    std::vector<Point> out;
    out.reserve(points.size());
    for (const Vec3d p : points) out.emplace_back(p.x, p.y, p.z);
    std::ranges::sort(out);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

bool in_one_plane(const std::vector<Point>& points) {
    std::size_t i = 1;  // the first that is not on a line with the first two
    while (i < points.size() && (i < 2 || CGAL::collinear(points[0], points[1], points[i]))) ++i;
    for (std::size_t j = 1; j < points.size(); ++j)
        if (i < points.size() && !CGAL::coplanar(points[0], points[1], points[i], points[j])) return false;
    return true;
}

/// Whether somewhere two neighbours lean towards each other on the outside, by more than six digits leave uncertain:
/// a hole is seen, however small beside the whole.
bool has_reflex_edge(const TriangleMesh& mesh) {
    constexpr double rounding = 1e-5;  // of the neighbours' size
    bool found = false;
    for_each_edge(mesh, [&](std::uint32_t a, std::uint32_t b, std::span<const HalfEdge> sides) {
        if (sides.size() != 2) return;
        const auto& [p, q, r] = mesh.triangles[sides[0].triangle];
        const Vec3d from = mesh.vertices[p], n = cross(mesh.vertices[q] - from, mesh.vertices[r] - from);
        for (const std::uint32_t v : mesh.triangles[sides[1].triangle]) {
            if (v == a || v == b) continue;
            const Vec3d d = mesh.vertices[v] - from;
            found = found || dot(d, n) > rounding * length(n) * length(d);
        }
    });
    return found;
}

}  // namespace

TriangleMesh convex_hull(std::span<const Vec3d> points) {
    TriangleMesh out;
    const std::vector<Point> corners = distinct(points);
    if (corners.size() < 4 || in_one_plane(corners)) return out;
    Mesh hull;
    CGAL::convex_hull_3(corners.begin(), corners.end(), hull);
    out.vertices.reserve(hull.number_of_vertices());
    for (const auto v : hull.vertices())
        out.vertices.push_back({hull.point(v).x(), hull.point(v).y(), hull.point(v).z()});
    out.triangles.reserve(hull.number_of_faces());
    for (const auto f : hull.faces()) {
        std::array<std::uint32_t, 3> triangle{};
        std::size_t i = 0;
        for (const auto v : hull.vertices_around_face(hull.halfedge(f)))
            if (i < 3) triangle[i++] = static_cast<std::uint32_t>(v.idx());
        out.triangles.push_back(triangle);
    }
    weld(out);
    return out;
}

std::vector<Vec2d> convex_hull(std::span<const Vec2d> points) {
    std::vector<Kernel::Point_2> given, corners;
    given.reserve(points.size());
    for (const Vec2d p : points) given.emplace_back(p.x, p.y);
    CGAL::convex_hull_2(given.begin(), given.end(), std::back_inserter(corners));
    std::vector<Vec2d> out;
    if (corners.size() < 3) return out;
    for (const auto& p : corners) out.push_back({p.x(), p.y()});
    return out;
}

bool is_convex(const TriangleMesh& mesh) {
    constexpr double rounding = 1e-7;  // of the volume: what six digits of coordinates leave uncertain
    if (!mesh.closed || has_reflex_edge(mesh)) return false;
    const double around = volume(convex_hull(mesh.vertices));
    return std::abs(around - volume(mesh)) <= rounding * around;
}

}  // namespace cardioid::csg

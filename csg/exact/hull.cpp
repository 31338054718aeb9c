#include "csg/exact/hull.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <variant>

#include "csg/shapes/mesh_edges.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "rt_core/math/box.hpp"

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

/// A convex solid as the faces between its half-spaces, cut down by one after the other. Each corner is where three of
/// their planes meet, so numbers stay as short as of the first cut.
class ConvexSolid {
    using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
    struct Face {
        std::size_t plane;
        std::vector<std::uint32_t> corners;  ///< counter-clockwise seen from outside
    };

public:
    /// A box, in which the solid lies with room on all sides.
    explicit ConvexSolid(const Box3d& box) {
        for (int corner = 0; corner < 8; ++corner)
            corners_.emplace_back((corner & 1 ? box.hi : box.lo).x, (corner & 2 ? box.hi : box.lo).y,
                                  (corner & 4 ? box.hi : box.lo).z);
        for (const auto& side : {std::array{0U, 4U, 6U, 2U},
                                 {1U, 3U, 7U, 5U},
                                 {0U, 1U, 5U, 4U},
                                 {2U, 6U, 7U, 3U},
                                 {0U, 2U, 3U, 1U},
                                 {4U, 5U, 7U, 6U}}) {
            faces_.push_back({planes_.size(), {side.begin(), side.end()}});
            planes_.emplace_back(corners_[side[0]], corners_[side[1]], corners_[side[2]]);
        }
    }

    /// Keeps what is on the side that a triangle, counter-clockwise seen from outside, turns away from.
    void cut(Vec3d a, Vec3d b, Vec3d c) {
        const Exact::Point_3 p(a.x, a.y, a.z), q(b.x, b.y, b.z), r(c.x, c.y, c.z);
        if (faces_.empty() || CGAL::collinear(p, q, r)) return;
        const Exact::Plane_3 by(p, q, r);
        std::unordered_map<std::uint32_t, CGAL::Oriented_side> side;
        bool beyond = false, within = false;
        for (const Face& face : faces_)
            for (const std::uint32_t v : face.corners) {
                const auto [at, fresh] = side.try_emplace(v, CGAL::ON_ORIENTED_BOUNDARY);
                if (fresh) at->second = by.oriented_side(corners_[v]);
                beyond = beyond || at->second == CGAL::ON_POSITIVE_SIDE;
                within = within || at->second == CGAL::ON_NEGATIVE_SIDE;
            }
        if (!within) faces_.clear();
        if (!beyond || !within) return;
        planes_.push_back(by);
        remove_beyond(side);
    }

    [[nodiscard]] TriangleMesh mesh() const {
        TriangleMesh out;
        for (const auto& p : corners_)
            out.vertices.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
        for (const Face& face : faces_)
            for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
                out.triangles.push_back({face.corners[0], face.corners[i], face.corners[i + 1]});
        weld(out);
        return out;
    }

private:
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    using Sides = std::unordered_map<std::uint32_t, CGAL::Oriented_side>;

    /// Cuts all faces by the last plane and closes the hole with a face of its own.
    void remove_beyond(const Sides& side) {
        std::map<Edge, std::size_t> plane_left_of;
        for (const Face& face : faces_)
            for (std::size_t i = 0; i < face.corners.size(); ++i)
                plane_left_of[{face.corners[i], face.corners[(i + 1) % face.corners.size()]}] = face.plane;
        std::map<Edge, std::uint32_t> cuts;  // new corners by the edges that they are on
        const auto cut_of = [&](std::size_t plane, std::uint32_t a, std::uint32_t b) {
            const auto [at, fresh] = cuts.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(corners_.size()));
            if (fresh) corners_.push_back(meeting(plane, plane_left_of.at({b, a}), planes_.size() - 1));
            return at->second;
        };
        std::map<std::uint32_t, std::uint32_t> next;  // around the new face
        std::vector<Face> kept;
        for (const Face& face : faces_) {
            Face part{face.plane, {}};
            std::vector<std::uint32_t> on;  // the new face's edge, if any
            for (std::size_t i = 0; i < face.corners.size(); ++i) {
                const std::uint32_t a = face.corners[i], b = face.corners[(i + 1) % face.corners.size()];
                const CGAL::Oriented_side at_a = side.at(a), at_b = side.at(b);
                if (at_a != CGAL::ON_POSITIVE_SIDE) part.corners.push_back(a);
                if (at_a == CGAL::ON_ORIENTED_BOUNDARY) on.push_back(a);
                if (at_a * at_b < 0) {
                    on.push_back(cut_of(face.plane, a, b));
                    part.corners.push_back(on.back());
                }
            }
            if (part.corners.size() < 3) continue;
            if (on.size() == 2) join(part, on, next);
            kept.push_back(std::move(part));
        }
        Face cap{planes_.size() - 1, {}};
        for (std::uint32_t v = next.begin()->first; cap.corners.size() < next.size(); v = next.at(v))
            cap.corners.push_back(v);
        kept.push_back(std::move(cap));
        faces_ = std::move(kept);
    }

    /// The edge between two corners on the plane, which the new face runs the other way.
    static void join(const Face& part, const std::vector<std::uint32_t>& on,
                     std::map<std::uint32_t, std::uint32_t>& next) {
        const auto first = std::ranges::find(part.corners, on[0]);
        const auto after = std::next(first) == part.corners.end() ? part.corners.begin() : std::next(first);
        if (*after == on[1])
            next[on[1]] = on[0];
        else
            next[on[0]] = on[1];
    }

    [[nodiscard]] Exact::Point_3 meeting(std::size_t a, std::size_t b, std::size_t c) const {
        const auto met = CGAL::intersection(planes_[a], planes_[b], planes_[c]);
        using boost::get;  // of what CGAL 5 gives
        using std::get;    // and CGAL 6
        return get<Exact::Point_3>(*met);
    }

    std::vector<Exact::Point_3> corners_;
    std::vector<Exact::Plane_3> planes_;
    std::vector<Face> faces_;
};

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

TriangleMesh convex_intersection(std::span<const TriangleMesh> parts) {
    Box3d box;
    for (const Vec3d v : parts[0].vertices) box.include(v);
    ConvexSolid solid(box.padded(box.diagonal()));
    for (const TriangleMesh& part : parts)
        for (const auto& [a, b, c] : part.triangles) solid.cut(part.vertices[a], part.vertices[b], part.vertices[c]);
    return solid.mesh();
}

}  // namespace cardioid::csg

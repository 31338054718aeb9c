#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/create_straight_skeleton_from_polygon_with_holes_2.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "csg/exact/mesh_cache.hpp"
#include "csg/shapes/extrude.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "rt_core/api/error.hpp"
#include "rt_core/math/box.hpp"

namespace cardioid::csg {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using Contour = std::vector<Vec2d>;

constexpr std::uint64_t roof_number = 0x526F6F66;  ///< tells roofs from what else is kept in the cache

[[noreturn]] void refuse() {
    throw Error(ErrorCode::bad_input, "roof() of a figure whose outlines touch: no straight skeleton was found");
}

double cross(Vec2d a, Vec2d b) { return a.x * b.y - a.y * b.x; }

double area(const Contour& contour) {
    double twice = 0;
    for (std::size_t i = 0; i < contour.size(); ++i) twice += cross(contour[i], contour[(i + 1) % contour.size()]);
    return twice / 2;
}

bool contains(const Contour& contour, Vec2d p) {
    bool inside = false;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const Vec2d a = contour[i], b = contour[(i + 1) % contour.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

/// Contours with the inside on their left: at a corner where it reaches around, those points of the corner are nearest
/// that no edge is nearest to, and the roof is a cone. Edges too short to be seen, on a round of `reach`, make it one.
Contour with_rounded_corners(const Contour& contour, int corners, double reach) {
    Contour out;
    const std::size_t n = contour.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2d at = contour[i], before = at - contour[(i + n - 1) % n], after = contour[(i + 1) % n] - at;
        const double lb = std::sqrt(dot(before, before)), la = std::sqrt(dot(after, after));
        const double turn = -std::atan2(cross(before, after), dot(before, after));
        const int steps = static_cast<int>(std::ceil(turn / (2 * std::numbers::pi) * corners - 1e-9));
        if (steps < 2) {
            out.push_back(at);
            continue;
        }
        // Chords of a circle that touches both edges, on the outer side.
        const double start = std::min({reach, la / 4, lb / 4}), r = start / std::tan(turn / 2);
        const Vec2d d = before * (1 / lb), away = Vec2d{d.y, -d.x} * r, centre = at - d * start + away;
        for (int k = 0; k <= steps; ++k) {
            const double angle = turn * k / steps;
            out.push_back(centre - away * std::cos(angle) + d * (r * std::sin(angle)));
        }
    }
    return out;
}

Polygon as_polygon(const Contour& contour) {
    Polygon out;
    for (const Vec2d p : contour) out.push_back({p.x, p.y});
    return out;
}

/// The roofs of an outline and its holes, as faces clockwise seen from outside.
class Roof {
public:
    void add(const CGAL::Polygon_with_holes_2<Kernel>& figure) {
        if (!figure.outer_boundary().is_simple()) refuse();
        const auto skeleton = CGAL::create_interior_straight_skeleton_2(figure, Kernel());
        if (!skeleton) refuse();
        std::unordered_map<int, std::uint32_t> number;
        for (auto v = skeleton->vertices_begin(); v != skeleton->vertices_end(); ++v) {
            number.emplace(v->id(), static_cast<std::uint32_t>(points.size()));
            points.push_back({v->point().x(), v->point().y(), v->is_contour() ? 0 : v->time()});
        }
        for (auto face = skeleton->faces_begin(); face != skeleton->faces_end(); ++face) {
            auto& corners = faces.emplace_back();
            auto h = face->halfedge();
            do {
                corners.push_back(number.at(h->vertex()->id()));
                h = h->next();
            } while (h != face->halfedge());
            std::ranges::reverse(corners);
        }
    }

    void add_floor(const Profile& figure) {
        const auto first = static_cast<std::uint32_t>(points.size());
        for (const Contour& contour : figure.contours)
            for (const Vec2d p : contour) points.push_back({p.x, p.y, 0});
        for (const auto& [a, b, c] : triangulate(figure)) faces.push_back({first + a, first + b, first + c});
    }

    std::vector<Vec3d> points;
    std::vector<std::vector<std::uint32_t>> faces;
};

TriangleMesh raise(const Profile& figure) {
    struct Outline {
        const Contour* contour;
        CGAL::Polygon_with_holes_2<Kernel> polygon;
    };
    std::vector<Outline> outlines;
    for (const Contour& contour : figure.contours)
        if (area(contour) > 0) outlines.push_back({&contour, CGAL::Polygon_with_holes_2<Kernel>(as_polygon(contour))});
    for (const Contour& hole : figure.contours) {
        if (area(hole) >= 0) continue;
        Outline* around = nullptr;
        for (Outline& outline : outlines)
            if (contains(*outline.contour, (hole[0] + hole[1]) * 0.5) &&
                (!around || area(*outline.contour) < area(*around->contour)))
                around = &outline;
        if (!around) refuse();
        around->polygon.add_hole(as_polygon(hole));
    }
    Roof roof;
    for (const Outline& outline : outlines) roof.add(outline.polygon);
    roof.add_floor(figure);
    MeshFaults faults;
    return triangulate_polyhedron(roof.points, roof.faces, faults);
}

}  // namespace

TriangleMesh roof(const Profile& profile, int corners) try {
    constexpr double unseen = 1e-5;  // of the figure's size
    Box3d box;
    for (const Contour& contour : profile.contours)
        for (const Vec2d p : contour) box.include(Vec3d{p.x, p.y, 0});
    Profile figure;
    ContentHash key;
    key.add(roof_number);
    for (const Contour& contour : profile.contours) {
        figure.contours.push_back(corners > 0 ? with_rounded_corners(contour, corners, unseen * box.diagonal())
                                              : contour);
        key.add(static_cast<std::uint64_t>(figure.contours.back().size()));
        for (const Vec2d p : figure.contours.back()) key.add(p.x), key.add(p.y);
    }
    return std::move(cached(key, [&] { return std::vector{raise(figure)}; })[0]);
} catch (const CGAL::Failure_exception&) {
    refuse();
}

}  // namespace cardioid::csg

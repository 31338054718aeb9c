#include "formats/openscad/geometry/plane.hpp"

#include <algorithm>
#include <cmath>

#include "csg/shapes/profile_boolean.hpp"
#include "formats/openscad/geometry/plane_files.hpp"
#include "formats/openscad/geometry/transforms.hpp"
#include "formats/openscad/text/text_figure.hpp"

namespace cardioid::formats::openscad {
namespace {

std::optional<Plane> removed(const Arguments& args, ShapeContext& context, const char* why) {
    context.warnings.add(args.where(), std::string(why) + ": removed");
    return std::nullopt;
}

bool positive(double x) { return x > 0 && std::isfinite(x); }

std::optional<Plane> square(const Arguments& args, ShapeContext& context) {
    const Vec3d size = args.size("size", 1);
    if (!positive(size.x) || !positive(size.y))
        return removed(args, context, "square() has a size that is not above 0 and finite");
    const Vec2d lo = args.boolean("center", false) ? Vec2d{size.x / -2, size.y / -2} : Vec2d{};
    const Vec2d hi = lo + Vec2d{size.x, size.y};
    return Plane{{{{lo, {hi.x, lo.y}, hi, {lo.x, hi.y}}}}, true, {}};
}

std::optional<Plane> circle(const Arguments& args, ShapeContext& context) {
    const auto d = args.number("d");
    const double r = d ? *d / 2 : args.number("r", 1);
    if (!positive(r)) return removed(args, context, "circle() has a radius that is not above 0 and finite");
    const csg::FacetSettings facets = facet_settings(args);
    if (is_curved(facets, context.options)) return Plane{{}, true, Affine::scaling({r, r, 1})};
    return Plane{{{csg::circle_points(r, csg::facet_count(r, facets))}}, true, {}};
}

/// The points, or nothing where one of them is not two finite numbers.
std::optional<std::vector<Vec2d>> read_points(const Arguments& args) {
    const Value* list = args.value("points");
    if (!list || list->kind != ValueKind::list) return std::nullopt;
    std::vector<Vec2d> out;
    for (const Value& row : args.ast().values_of(*list)) {
        if (row.kind != ValueKind::numbers || row.count < 2) return std::nullopt;
        const auto xs = args.ast().numbers_of(row);
        if (!std::isfinite(xs[0]) || !std::isfinite(xs[1])) return std::nullopt;
        out.push_back({xs[0], xs[1]});
    }
    return out;
}

std::vector<Vec2d> read_path(std::span<const double> indices, const std::vector<Vec2d>& points) {
    std::vector<Vec2d> out;
    for (const double i : indices)
        if (i >= 0 && i < static_cast<double>(points.size())) out.push_back(points[static_cast<std::size_t>(i)]);
    return out;
}

std::optional<Plane> polygon(const Arguments& args, ShapeContext& context) {
    const auto points = read_points(args);
    if (!points) return removed(args, context, "polygon() has a point that is not two finite numbers");
    Plane out;
    const Value* paths = args.value("paths");
    if (paths && paths->kind == ValueKind::numbers && paths->count > 0) {
        out.profile.contours.push_back(read_path(args.ast().numbers_of(*paths), *points));  // one path without brackets
    } else if (paths && paths->kind == ValueKind::list) {
        for (const Value& path : args.ast().values_of(*paths))
            if (path.kind == ValueKind::numbers)
                out.profile.contours.push_back(read_path(args.ast().numbers_of(path), *points));
    } else {
        out.profile.contours.push_back(*points);
    }
    std::erase_if(out.profile.contours, [](const auto& contour) { return contour.size() < 3; });
    if (out.profile.empty()) return removed(args, context, "polygon() has fewer than three points");
    return out;
}

double signed_area(const std::vector<Vec2d>& contour) {
    double twice = 0;
    for (std::size_t i = 0; i < contour.size(); ++i)
        twice += cross(contour[i] - contour[0], contour[(i + 1) % contour.size()] - contour[0]);
    return twice / 2;
}

struct Edge {
    Vec2d a, b;
    std::size_t contour, index;
};

bool between(Vec2d p, const Edge& e) {
    return p.x >= std::min(e.a.x, e.b.x) && p.x <= std::max(e.a.x, e.b.x) && p.y >= std::min(e.a.y, e.b.y) &&
           p.y <= std::max(e.a.y, e.b.y);
}

/// Whether two edges have a point in common.
bool touch(const Edge& e, const Edge& f) {
    const auto side = [](const Edge& g, Vec2d p) { return cross(g.b - g.a, p - g.a); };
    const double ea = side(f, e.a), eb = side(f, e.b), fa = side(e, f.a), fb = side(e, f.b);
    if (((ea > 0) != (eb > 0)) && ((fa > 0) != (fb > 0)) && ea != 0 && eb != 0 && fa != 0 && fb != 0) return true;
    return (ea == 0 && between(e.a, f)) || (eb == 0 && between(e.b, f)) || (fa == 0 && between(f.a, e)) ||
           (fb == 0 && between(f.b, e));
}

/// Whether neighbours e and f, e before f, run back over one another.
bool folds_back(const Edge& e, const Edge& f) {
    return cross(e.b - e.a, f.b - f.a) == 0 && dot(e.b - e.a, f.b - f.a) <= 0;
}

std::vector<Edge> edges_of(const Profile& profile) {
    std::vector<Edge> out;
    for (std::size_t c = 0; c < profile.contours.size(); ++c)
        for (std::size_t i = 0; i < profile.contours[c].size(); ++i)
            out.push_back({profile.contours[c][i], profile.contours[c][(i + 1) % profile.contours[c].size()], c, i});
    return out;
}

bool is_simple(const Profile& profile) {
    const std::vector<Edge> edges = edges_of(profile);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (edges[i].a == edges[i].b) return false;
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            const Edge &e = edges[i], &f = edges[j];
            const std::size_t n = profile.contours[e.contour].size();
            const bool before = e.contour == f.contour && (e.index + 1) % n == f.index;
            const bool behind = e.contour == f.contour && (f.index + 1) % n == e.index;
            if (before || behind ? (before ? folds_back(e, f) : folds_back(f, e)) : touch(e, f)) return false;
        }
    }
    return true;
}

Plane combine(csg::ProfileOp op, std::span<const Plane> parts, const ShapeContext& context) {
    std::vector<Profile> profiles;
    double largest = 0;
    for (const Plane& part : parts) {
        profiles.push_back(as_profile(part));
        for (const auto& contour : profiles.back().contours)
            for (const Vec2d p : contour) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    }
    return {csg::profile_boolean(op, profiles, grid_of(largest, context.options)), true, {}};
}

}  // namespace

Profile as_profile(const Plane& plane) {
    if (!plane.circle) return plane.profile;
    return csg::transformed({{csg::circle_points(1, fine_circle)}}, *plane.circle);
}

double grid_of(double largest, const ReadOptions& options) {
    constexpr double openscad_grid = 0x1p-16;
    constexpr int fine_bits = 40;  // below the largest coordinate: far finer than a picture or 6 digits show
    if (options.openscad_facets || largest == 0) return openscad_grid;
    return std::ldexp(1.0, std::ilogb(largest) - fine_bits);
}

std::optional<Plane> carried(Plane plane, const Affine& map, const Arguments& args, ShapeContext& context) {
    if (map == Affine{}) return plane;
    if (is_singular(map)) return removed(args, context, "a plane figure is scaled by 0 or by what is not finite");
    if (plane.circle)
        plane.circle = map * *plane.circle;
    else
        plane.profile = csg::transformed(plane.profile, map);
    return plane;
}

std::optional<Plane> make_plane(Node node, const Arguments& args, const Affine& map, ShapeContext& context) {
    std::optional<Plane> out = node == Node::square        ? square(args, context)
                               : node == Node::circle      ? circle(args, context)
                               : node == Node::polygon     ? polygon(args, context)
                               : node == Node::import_file ? plane_file(args, context)
                                                           : text_figure(args, context);
    if (!out) return out;
    return carried(std::move(*out), map, args, context);
}

Plane unite(std::span<const Plane> parts, const ShapeContext& context) {
    if (parts.empty()) return {.profile = {}, .clean = true, .circle = {}};
    return parts.size() == 1 ? parts[0] : combine(csg::ProfileOp::unite, parts, context);
}

Plane intersect(std::span<const Plane> parts, const ShapeContext& context) {
    return combine(csg::ProfileOp::intersect, parts, context);
}

Plane subtract(std::span<const Plane> parts, const ShapeContext& context) {
    return parts.size() == 1 ? parts[0] : combine(csg::ProfileOp::subtract, parts, context);
}

Profile contours_of(const Plane& plane, const ShapeContext& context) {
    Profile out = as_profile(plane);
    if (plane.clean) return out;
    if (!context.options.openscad_facets && orient_if_simple(out)) return out;
    return combine(csg::ProfileOp::unite, std::span(&plane, 1), context).profile;
}

bool orient_if_simple(Profile& profile) {
    if (edge_count(profile) > most_profile_edges || !is_simple(profile)) return false;
    std::vector<bool> hole;
    for (std::size_t i = 0; i < profile.contours.size(); ++i) {
        bool odd = false;
        for (std::size_t j = 0; j < profile.contours.size(); ++j)
            if (j != i) odd ^= csg::contains({{profile.contours[j]}}, profile.contours[i][0]);
        hole.push_back(odd);
    }
    for (std::size_t i = 0; i < profile.contours.size(); ++i) {
        const double area = signed_area(profile.contours[i]);
        if (!(std::abs(area) > 0)) return false;
        if ((area < 0) != hole[i]) std::reverse(profile.contours[i].begin() + 1, profile.contours[i].end());
    }
    return true;
}

}  // namespace cardioid::formats::openscad

#include "formats/openscad/geometry/extrusions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "csg/shapes/degrees.hpp"
#include "csg/shapes/extrude.hpp"
#include "formats/openscad/geometry/transforms.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats::openscad {
namespace {

Extrusion removed(const Arguments& args, ShapeContext& context, const char* why) {
    context.warnings.add(args.where(), std::string(why) + ": removed");
    return {};
}

/// The scale of the top; below zero is zero, as in OpenSCAD.
Vec2d top_scale(const Arguments& args) {
    Vec2d out{1, 1};
    if (args.is("scale", ValueKind::number)) {
        out.x = out.y = args.number("scale", 1);
    } else if (const auto xs = args.numbers("scale", 2)) {
        out = {(*xs)[0], (*xs)[1]};
    }
    return {std::max(out.x, 0.0), std::max(out.y, 0.0)};
}

/// Later versions of OpenSCAD extrude along `v`; straight up is what this one knows.
double extrusion_height(const Arguments& args) {
    double height = args.number("height", args.number("h", 100));
    if (const auto v = args.vector("v")) {
        if (v->x != 0 || v->y != 0 || !(v->z > 0)) args.fail("linear_extrude along a slanting v is not supported yet");
        if (!args.has("height") && !args.has("h")) height = v->z;
    }
    return height;
}

/// A circle swept up: a cone whose axis may slant, because the top is scaled about the origin.
Shape swept_circle(const Affine& circle, double height, double scale) {
    Affine local = circle;
    local.row[0].z = circle.t.x * (scale - 1);
    local.row[1].z = circle.t.y * (scale - 1);
    local.row[2] = {0, 0, height};
    return {LeafKind::cone, local, 1, scale};
}

/// The radius of a map that is a similarity of the plane, mirrored or not; 0 of any other.
double circle_radius(const Affine& map) {
    constexpr double round = 1e-5;  // matrices are printed with 6 digits
    const Vec3d x = map.column(0), y = map.column(1);
    const double rx = length(x), ry = length(y);
    return std::abs(rx - ry) <= round * rx && std::abs(dot(x, y)) <= round * rx * ry ? rx : 0;
}

/// A mistaken twist or number of slices would fill the memory for minutes before anyone hears of it.
void refuse_many_triangles(double triangles, double most, const std::string& where) {
    if (triangles > most)
        throw Error(ErrorCode::limit, fmt::format("{}: linear_extrude() would make {:.0f} triangles, wanted at most "
                                                  "{:.0f}: fewer slices or less twist, or --set csg.triangles={:.0f}",
                                                  where, triangles, most, triangles));
}

/// A profile swept up: a prism where that can be met analytically, else a mesh.
std::optional<Shape> extruded(Profile profile, const csg::LinearExtrusion& how, const std::string& where,
                              ShapeContext& context) {
    const bool even = how.twist_deg == 0 && how.scale.x == how.scale.y && how.scale.x > 0;
    if (!even || edge_count(profile) > most_profile_edges) {
        refuse_many_triangles(2.0 * csg::slice_count(profile, how) * static_cast<double>(edge_count(profile)),
                              context.limits.triangles, where);
        return make_mesh(csg::linear_extrude(profile, how), where, context);
    }
    const Affine local{{Vec3d{1, 0, 0}, {0, 1, 0}, {0, 0, how.height}}, {0, 0, how.centre ? how.height / -2 : 0}};
    return Shape{LeafKind::prism, local, how.scale.x, 0, context.solids.add_profile(std::move(profile))};
}

struct Sweep {
    double angle = 360, start = 0;  ///< degrees
};

Sweep read_sweep(const Arguments& args) {
    Sweep out;
    out.angle = args.number("angle", 360);
    if (!std::isfinite(out.angle) || out.angle <= -360 || out.angle > 360) out.angle = 360;
    // OpenSCAD 2021.01 begins a whole turn at -x and any other at +x; later versions say where.
    const double usual = out.angle == 360 ? 180 : 0;
    out.start = args.number("start", usual) - usual;
    if (!std::isfinite(out.start)) out.start = 0;
    return out;
}

/// The half-spaces that keep azimuths from `from` on, up to 180 degrees, and those up to `to`.
void add_wedge(const Sweep& sweep, Extrusion& out) {
    double from = std::min(0.0, sweep.angle), to = std::max(0.0, sweep.angle);
    const double opening = to - from;
    out.keep_wedge = opening <= 180;
    if (!out.keep_wedge) std::swap(from, to);  // what is cut away begins where the sweep ends
    const auto [s0, c0] = csg::sin_cos_deg(from);
    const auto [s1, c1] = csg::sin_cos_deg(to);
    out.wedge.push_back({LeafKind::half_space, rotation_to({s0, -c0, 0})});
    if (opening != 180) out.wedge.push_back({LeafKind::half_space, rotation_to({-s1, c1, 0})});
}

/// The true solid of revolution of a profile on the side of +x, or a mesh where it has many edges.
std::optional<Shape> revolve(const Profile& profile, const Arguments& args, ShapeContext& context) {
    if (edge_count(profile) <= most_profile_edges)
        return Shape{LeafKind::revolution, {}, 0, 0, context.solids.add_profile(profile)};
    return make_mesh(csg::rotate_extrude(profile, 360, {.fn = fine_circle}), args.where(), context);
}

/// Both sides of the axis may hold the figure, not each a part of it: carries it to x >= 0. False where it has both.
bool to_right_side(Profile& profile, bool& mirrored) {
    double lo = 0, hi = 0;
    for (const auto& contour : profile.contours)
        for (const Vec2d p : contour) lo = std::min(lo, p.x), hi = std::max(hi, p.x);
    if (lo < 0 && hi > 0) return false;
    mirrored = lo < 0;
    if (!mirrored) return true;
    for (auto& contour : profile.contours) {
        for (Vec2d& p : contour) p.x = -p.x;
        std::reverse(contour.begin(), contour.end());
    }
    return true;
}

}  // namespace

Extrusion linear_extrusion(std::span<const Plane> parts, const Arguments& args, ShapeContext& context) {
    csg::LinearExtrusion how;
    how.height = extrusion_height(args);
    how.centre = args.boolean("center", false);
    how.twist_deg = args.number("twist", 0);
    how.slices = static_cast<int>(std::clamp(args.number("slices", 0), 0.0, 2e9));
    how.scale = top_scale(args);
    how.facets = facet_settings(args);
    if (!std::isfinite(how.twist_deg) || !std::isfinite(how.scale.x) || !std::isfinite(how.scale.y))
        return removed(args, context, "linear_extrude() has a twist or scale that is not finite");
    if (!(how.height > 0) || !std::isfinite(how.height))
        return removed(args, context, "linear_extrude() has a height that is not above 0 and finite");
    const Affine lift = Affine::translation({0, 0, how.centre ? how.height / -2 : 0});
    const bool even = how.twist_deg == 0 && how.scale.x == how.scale.y;
    Extrusion out;
    if (even && parts.size() == 1 && parts[0].circle) {
        out.body = swept_circle(*parts[0].circle, how.height, how.scale.x);
        out.body->local = lift * out.body->local;
        return out;
    }
    Profile profile = contours_of(unite(parts, context), context);
    if (profile.empty()) return out;
    out.body = extruded(std::move(profile), how, args.where(), context);
    return out;
}

std::optional<Shape> plate(std::span<const Plane> parts, const std::string& where, ShapeContext& context) {
    Profile profile = contours_of(unite(parts, context), context);
    if (profile.empty()) return std::nullopt;
    return extruded(std::move(profile), {.height = 1, .centre = true}, where, context);
}

Extrusion rotate_extrusion(std::span<const Plane> parts, const Arguments& args, ShapeContext& context) {
    const Sweep sweep = read_sweep(args);
    if (sweep.angle == 0) return removed(args, context, "rotate_extrude() has an angle of 0");
    const csg::FacetSettings facets = facet_settings(args);
    const Affine turn = sweep.start == 0 ? Affine{} : rotation_z(sweep.start);
    const bool curved = is_curved(facets, context.options);
    Extrusion out;
    if (curved && parts.size() == 1 && parts[0].circle) {
        const Vec3d centre = parts[0].circle->t;
        const double r = circle_radius(*parts[0].circle);
        if (r > 0 && std::abs(centre.x) > r)
            out.body = Shape{LeafKind::torus, Affine::translation({0, 0, centre.y}), std::abs(centre.x), r};
    }
    bool mirrored = out.body && parts[0].circle->t.x < 0;
    if (!out.body) {
        Profile profile = contours_of(unite(parts, context), context);
        if (profile.empty()) return out;
        const Profile as_given = profile;
        if (!to_right_side(profile, mirrored))
            return removed(args, context, "rotate_extrude() has points on both sides of the axis");
        if (!curved) {
            out.body = make_mesh(csg::rotate_extrude(as_given, sweep.angle, facets), args.where(), context);
            if (out.body) out.body->local = turn * out.body->local;
            return out;
        }
        out.body = revolve(profile, args, context);
        if (!out.body) return out;
    }
    if (sweep.angle != 360) add_wedge(sweep, out);
    const Affine side = mirrored ? turn * rotation_z(180) : turn;
    for (Shape& half : out.wedge) half.local = side * half.local;
    return out;
}

}  // namespace cardioid::formats::openscad

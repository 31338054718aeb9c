#include "formats/openscad/geometry/plane_operations.hpp"

#include <algorithm>
#include <cmath>

#include "csg/exact/hull.hpp"
#include "csg/exact/tessellate.hpp"
#include "csg/shapes/profile_boolean.hpp"
#include "csg/shapes/profile_offset.hpp"
#include "formats/openscad/geometry/transforms.hpp"

namespace cardioid::formats::openscad {
namespace {

/// The greatest size of a coordinate of a figure.
double largest(const Profile& profile) {
    double out = 0;
    for (const auto& contour : profile.contours)
        for (const Vec2d p : contour) out = std::max({out, std::abs(p.x), std::abs(p.y)});
    return out;
}

std::optional<Plane> if_any(Profile profile) {
    if (profile.empty()) return std::nullopt;
    return Plane{std::move(profile), true, {}};
}

std::optional<Plane> hull(const std::vector<Plane>& parts) {
    std::vector<Vec2d> points;
    for (const Plane& part : parts)
        for (const auto& contour : as_profile(part).contours)
            points.insert(points.end(), contour.begin(), contour.end());
    std::vector<Vec2d> corners = csg::convex_hull(points);
    if (corners.empty()) return std::nullopt;
    return if_any({{std::move(corners)}});
}

std::optional<Plane> minkowski(const std::vector<Plane>& parts, ShapeContext& context) {
    if (parts.size() == 1) return parts[0];
    Profile sum = contours_of(parts[0], context);
    for (std::size_t i = 1; i < parts.size() && !sum.empty(); ++i) {
        const Profile next = contours_of(parts[i], context);
        sum = csg::profile_minkowski(sum, next, grid_of(largest(sum) + largest(next), context.options));
    }
    return if_any(std::move(sum));
}

std::optional<Plane> resize(const std::vector<Plane>& parts, const Arguments& args, ShapeContext& context) {
    Plane whole = unite(parts, context);
    Box3d box;
    if (whole.circle) {
        const Affine& m = *whole.circle;
        const Vec3d reach{std::hypot(m.row[0].x, m.row[0].y), std::hypot(m.row[1].x, m.row[1].y), 0};
        box = {m.t - reach, m.t + reach};
    }
    for (const auto& contour : whole.profile.contours)
        for (const Vec2d p : contour) box.include(Vec3d{p.x, p.y, 0});
    if (box.empty()) return std::nullopt;
    return carried(std::move(whole), Affine::scaling(resize_scale(args, box.size(), 2)), args, context);
}

/// Corners of a whole circle of radius r about the corner of a figure of this size.
double arc_corners(double r, double size, const Arguments& args, ShapeContext& context) {
    constexpr double chord_share = 1e-4;
    const csg::FacetSettings facets = facet_settings(args);
    return is_curved(facets, context.options) ? csg::fine_corners(r, chord_share * size) : csg::facet_count(r, facets);
}

/// A circle that stays one.
std::optional<Plane> grown_circle(const std::vector<Plane>& parts, double distance) {
    if (parts.size() != 1 || !parts[0].circle) return std::nullopt;
    const Affine& m = *parts[0].circle;
    const double r = length(m.column(0)), grown = r + distance;
    constexpr double round = 1e-5;  // matrices are printed with 6 digits
    const bool is_round =
        std::abs(length(m.column(1)) - r) <= round * r && std::abs(dot(m.column(0), m.column(1))) <= round * r * r;
    if (!is_round || !(grown > 0)) return std::nullopt;
    return Plane{{}, true, Affine::translation(m.t) * Affine::scaling({grown, grown, 1})};
}

std::optional<Plane> offset(const std::vector<Plane>& parts, const Arguments& args, ShapeContext& context) {
    double distance = 1;
    csg::Corner corner = csg::Corner::round;
    if (args.is("r", ValueKind::number)) {
        distance = args.number("r", 1);
    } else if (args.is("delta", ValueKind::number)) {
        distance = args.number("delta", 1);
        corner = args.boolean("chamfer", false) ? csg::Corner::chamfer : csg::Corner::mitre;
    }
    if (!std::isfinite(distance)) args.fail("offset() by what is not finite");
    if (auto circle = grown_circle(parts, distance)) return circle;
    const Profile whole = contours_of(unite(parts, context), context);
    if (whole.empty()) return std::nullopt;
    const double reach = largest(whole) + std::abs(distance);
    return if_any(csg::profile_offset(whole, distance, corner, arc_corners(std::abs(distance), reach, args, context),
                                      grid_of(reach, context.options)));
}

std::optional<Plane> fill(const std::vector<Plane>& parts, ShapeContext& context) {
    const Profile whole = contours_of(unite(parts, context), context);
    return if_any(csg::without_holes(whole, grid_of(largest(whole), context.options)));
}

}  // namespace

std::optional<Plane> operate_on_planes(Node node, std::vector<Plane> parts, const Arguments& args,
                                       ShapeContext& context) {
    switch (node) {
        case Node::hull:
            return hull(parts);
        case Node::minkowski:
            return minkowski(parts, context);
        case Node::resize:
            return resize(parts, args, context);
        case Node::offset:
            return offset(parts, args, context);
        case Node::fill:
            return fill(parts, context);
        default:
            return std::nullopt;
    }
}

Vec3d resize_scale(const Arguments& args, Vec3d size, int dimensions) {
    const Vec3d wanted = args.vector("newsize").value_or(Vec3d{});
    Vec3d automatic;
    if (const Value* value = args.value("auto")) {
        if (value->kind == ValueKind::boolean)
            automatic = args.boolean("auto", false) ? Vec3d{1, 1, 1} : Vec3d{};
        else if (value->kind == ValueKind::numbers)
            automatic = args.vector("auto").value_or(Vec3d{});
    }
    int greatest = 0;  // the side that sets the scale of the automatic ones
    for (int i = 1; i < dimensions; ++i)
        if (wanted[i] > wanted[greatest]) greatest = i;
    Vec3d scale{1, 1, 1};
    for (int i = 0; i < dimensions; ++i)
        if (wanted[i] > 0 && size[i] > 0 && std::isfinite(wanted[i])) scale[i] = wanted[i] / size[i];
    const double of_greatest = scale[greatest];
    for (int i = 0; i < dimensions; ++i)
        if (automatic[i] != 0 && !(wanted[i] > 0)) scale[i] = of_greatest;
    return scale;
}

}  // namespace cardioid::formats::openscad

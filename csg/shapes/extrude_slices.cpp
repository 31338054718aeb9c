#include <algorithm>
#include <cmath>
#include <numbers>

#include "csg/shapes/extrude.hpp"

namespace cardioid::csg {

namespace {

/// OpenSCAD's GRID_FINE: what moves less than this needs one slice.
constexpr double smallest_move = 0x1p-20;
constexpr double smallest_setting = 0.01;  ///< of $fa and $fs
constexpr double most_slices = 1e9;        ///< keeps the conversion to int defined

int to_count(double count, int least) { return std::max(least, static_cast<int>(std::clamp(count, 1.0, most_slices))); }

/// What the slices follow: the path of the corner that moves most.
struct Path {
    double radius = 0;  ///< greatest distance of a corner from the axis
    double moved = 0;   ///< greatest way of a corner by the scale alone
};

Path longest_path(const Profile& profile, Vec2d scale) {
    Path out;
    for (const auto& contour : profile.contours)
        for (const Vec2d p : contour) {
            out.radius = std::max(out.radius, length(p));
            out.moved = std::max(out.moved, length(p - Vec2d{p.x * scale.x, p.y * scale.y}));
        }
    return out;
}

/// Length of an Archimedean spiral r = a theta from 0 to theta.
double spiral_length(double a, double theta) {
    return a / 2 * (theta * std::sqrt(1 + theta * theta) + std::asinh(theta));
}

/// Way in the plane of a corner that turns by `radians` while its distance from the axis changes from r to scale r.
double plane_length(double r, double radians, double scale) {
    if (scale == 1) return r * radians;
    const double end = scale > 1 ? radians * scale / (scale - 1) : radians / (1 - scale);
    return spiral_length(r / end, end) - spiral_length(r / end, end - radians);
}

/// Slices of a twist: $fn a turn, else the lesser of $fa and $fs along the path; at least one for 120 degrees.
int twist_slices(const LinearExtrusion& how, double radius, double scale) {
    const double twist = std::abs(how.twist_deg);
    const int least = to_count(std::ceil(twist / 120), 1);
    if (radius < smallest_move || !std::isfinite(how.facets.fn)) return least;
    if (how.facets.fn > 0) return to_count(std::ceil(twist / 360 * how.facets.fn), least);
    const double way = std::hypot(plane_length(radius, twist * (std::numbers::pi / 180), scale), how.height);
    const double by_angle = std::ceil(twist / std::max(smallest_setting, how.facets.fa));
    const double by_length = std::ceil(way / std::max(smallest_setting, how.facets.fs));
    return to_count(std::min(by_angle, by_length), least);
}

/// Slices of an uneven scale without twist: $fn, else $fs along the path.
int stretch_slices(const LinearExtrusion& how, double moved) {
    if (moved < smallest_move || !std::isfinite(how.facets.fn)) return 1;
    if (how.facets.fn > 0) return to_count(std::floor(how.facets.fn), 1);
    return to_count(std::ceil(std::hypot(moved, how.height) / std::max(smallest_setting, how.facets.fs)), 1);
}

}  // namespace

int slice_count(const Profile& profile, const LinearExtrusion& how) {
    if (how.slices > 0) return how.slices;
    const Vec2d scale{std::max(0.0, how.scale.x), std::max(0.0, how.scale.y)};
    const bool even = scale.x == scale.y;
    if (how.twist_deg == 0 && even) return 1;
    const Path path = longest_path(profile, scale);
    if (how.twist_deg == 0) return stretch_slices(how, path.moved);
    return twist_slices(how, path.radius, even ? scale.x : 1);
}

}  // namespace cardioid::csg

#pragma once
/// The solvers behind append_events, one file a family; all in the leaf's local space.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "csg/leaves/leaf.hpp"

namespace cardioid::csg {

/// An interval of a line that is inside a convex leaf, with the faces at its ends; empty where !(t0 < t1).
struct Span {
    double t0, t1;
    std::uint32_t face0 = 0, face1 = 0;
    [[nodiscard]] bool empty() const { return !(t0 < t1); }
};
inline constexpr Span no_span{1, 0};

/// Narrows `span` to lo <= o + t d <= hi of one coordinate.
inline void clip(Span& span, double o, double d, double lo, double hi, std::uint32_t face_lo, std::uint32_t face_hi) {
    if (std::abs(d) < 1e-300) {  // too small to invert
        if (o <= lo || o >= hi) span = no_span;
        return;
    }
    const double inverse = 1 / d;
    double t0 = (lo - o) * inverse, t1 = (hi - o) * inverse;
    if (d < 0) std::swap(t0, t1), std::swap(face_lo, face_hi);
    if (t0 > span.t0) span.t0 = t0, span.face0 = face_lo;
    if (t1 < span.t1) span.t1 = t1, span.face1 = face_hi;
}

inline Span ball_span(Vec3d centre, double radius, Vec3d o, Vec3d d) {
    const double dd = dot(d, d);
    const double middle = dot(centre - o, d) / dd;
    const Vec3d closest = o + d * middle - centre;
    const double height_square = radius * radius - dot(closest, closest);
    if (!(height_square > 0)) return no_span;
    const double half = std::sqrt(height_square / dd);
    return {middle - half, middle + half};
}

/// Where the line is inside a convex leaf.
Span convex_leaf_span(const SolvedLeaf& leaf, Vec3d o, Vec3d d);
Span unit_sphere_span(Vec3d o, Vec3d d);
/// Faces 0 to 5: x low, x high, y low ...
inline Span axis_box_span(Vec3d lo, Vec3d hi, Vec3d o, Vec3d d) {
    // No branch on numbers that change from ray to ray: a processor that guesses wrong waits longer than all this
    // takes.
    double near[3], far[3];
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(d[axis]) < 1e-300) {  // too small to invert
            if (o[axis] <= lo[axis] || o[axis] >= hi[axis]) return no_span;
            near[axis] = -std::numeric_limits<double>::infinity();
            far[axis] = std::numeric_limits<double>::infinity();
            continue;
        }
        const double inverse = 1 / d[axis];
        const double a = (lo[axis] - o[axis]) * inverse, b = (hi[axis] - o[axis]) * inverse;
        near[axis] = std::min(a, b);
        far[axis] = std::max(a, b);
    }
    Span span{std::max(near[0], std::max(near[1], near[2])), std::min(far[0], std::min(far[1], far[2]))};
    if (span.empty()) return no_span;
    const std::uint32_t in = span.t0 == near[0] ? 0 : span.t0 == near[1] ? 1 : 2;
    const std::uint32_t out = span.t1 == far[0] ? 0 : span.t1 == far[1] ? 1 : 2;
    span.face0 = 2 * in + (d[static_cast<int>(in)] < 0 ? 1 : 0);
    span.face1 = 2 * out + (d[static_cast<int>(out)] < 0 ? 0 : 1);
    return span;
}

/// Faces: 0 side, 1 at z = 0, 2 at z = 1.
Span cone_span(double a, double b, Vec3d o, Vec3d d);
Span half_space_span(Vec3d o, Vec3d d);
Span convex_span(const std::vector<Plane>& planes, Vec3d o, Vec3d d);

/// Up to four crossings of the torus of ring radius R and tube radius r, sorted, even in number; returns how many.
int torus_roots(double R, double r, Vec3d o, Vec3d d, std::array<double, 4>& roots);

void append_prism(const SolvedLeaf& leaf, std::uint32_t index, Vec3d o, Vec3d d, EventList& out);
void append_revolution(const SolvedLeaf& leaf, std::uint32_t index, Vec3d o, Vec3d d, EventList& out);
Vec3d prism_normal(const SolvedLeaf& leaf, std::uint32_t face);
Vec3d revolution_normal(const SolvedLeaf& leaf, std::uint32_t face, Vec3d p);

/// A profile whose prism is convex becomes planes; empty where it is not, or has more than `limit` corners.
std::vector<Plane> convex_prism_planes(const Profile& profile, double top_scale, std::size_t limit);

}  // namespace cardioid::csg

#pragma once
/// The solvers behind append_events, one file a family; all in the leaf's local space.
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

Span unit_sphere_span(Vec3d o, Vec3d d);
inline Span axis_box_span(Vec3d lo, Vec3d hi, Vec3d o, Vec3d d) {
    Span span{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    clip(span, o.x, d.x, lo.x, hi.x, 0, 1);
    clip(span, o.y, d.y, lo.y, hi.y, 2, 3);
    clip(span, o.z, d.z, lo.z, hi.z, 4, 5);
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

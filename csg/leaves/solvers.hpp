#pragma once
/// The solvers behind append_events, one file a family; all in the leaf's local space.
#include "csg/leaves/leaf.hpp"

namespace cardioid::csg {

/// An interval of a line that is inside a convex leaf, with the faces at its ends; empty where !(t0 < t1).
struct Span {
    double t0, t1;
    std::uint32_t face0 = 0, face1 = 0;
    [[nodiscard]] bool empty() const { return !(t0 < t1); }
};
inline constexpr Span no_span{1, 0};

Span ball_span(Vec3d centre, double radius, Vec3d o, Vec3d d);
Span unit_sphere_span(Vec3d o, Vec3d d);
Span axis_box_span(Vec3d lo, Vec3d hi, Vec3d o, Vec3d d);
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

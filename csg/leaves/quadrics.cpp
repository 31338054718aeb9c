#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "csg/leaves/solvers.hpp"

namespace cardioid::csg {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Parts of a line where f(t) = a t^2 + 2 b t + c <= 0: between the roots for a > 0, outside them for a < 0.
struct Roots {
    double t0, t1;
    bool real;
};

/// Both roots without cancellation (Press et al., Numerical Recipes, 5.6); a must not be 0.
Roots quadratic_roots(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return {0, 0, false};
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    double t0 = q / a, t1 = q != 0 ? c / q : 0;
    if (t0 > t1) std::swap(t0, t1);
    return {t0, t1, true};
}

/// Distance along the line to its point closest to p; solving from there keeps far origins exact.
double closest_approach(Vec3d p, Vec3d o, Vec3d d) { return dot(p - o, d) / dot(d, d); }

}  // namespace

Span unit_sphere_span(Vec3d o, Vec3d d) { return ball_span({0, 0, 0}, 1, o, d); }

Span half_space_span(Vec3d o, Vec3d d) {
    if (d.z == 0) return o.z <= 0 ? Span{-infinity, infinity} : no_span;
    const double t = -o.z / d.z;
    return d.z > 0 ? Span{-infinity, t} : Span{t, infinity};
}

Span convex_span(const std::vector<Plane>& planes, Vec3d o, Vec3d d) {
    Span span{-infinity, infinity};
    for (std::uint32_t i = 0; i < planes.size(); ++i) {
        const double nd = dot(planes[i].n, d), distance = planes[i].d - dot(planes[i].n, o);
        if (nd == 0) {
            if (distance <= 0) return no_span;
        } else if (const double t = distance / nd; nd > 0) {
            if (t < span.t1) span.t1 = t, span.face1 = i;
        } else if (t > span.t0) {
            span.t0 = t, span.face0 = i;
        }
        if (span.empty()) return no_span;
    }
    return span;
}

Span cone_span(double a, double b, Vec3d o, Vec3d d) {
    const double middle = closest_approach({0, 0, 0.5}, o, d);
    const Vec3d p = o + d * middle;
    const double slope = b - a, radius = a + slope * p.z, dr = slope * d.z;
    const double qa = d.x * d.x + d.y * d.y - dr * dr;
    const double qb = p.x * d.x + p.y * d.y - radius * dr;
    const double qc = p.x * p.x + p.y * p.y - radius * radius;
    const double flat = 1e-14 * (d.x * d.x + d.y * d.y + dr * dr);
    if (qa > flat && qb * qb <= qa * qc) return no_span;  // passes by, which is what most lines do
    Span slab{-infinity, infinity};
    clip(slab, o.z, d.z, 0, 1, 1, 2);
    if (slab.empty()) return no_span;
    const auto intersected = [&](double t0, double t1) {
        Span s = slab;
        if (t0 + middle > s.t0) s.t0 = t0 + middle, s.face0 = 0;
        if (t1 + middle < s.t1) s.t1 = t1 + middle, s.face1 = 0;
        return s;
    };
    if (std::abs(qa) <= flat) {  // parallel to the side, or along the axis
        if (qb == 0) return qc < 0 ? slab : no_span;
        const double t = -qc / (2 * qb);
        return qb > 0 ? intersected(-infinity, t) : intersected(t, infinity);
    }
    const Roots roots = quadratic_roots(qa, qb, qc);
    if (qa > 0) return roots.real ? intersected(roots.t0, roots.t1) : no_span;
    if (!roots.real) return slab;  // inside one nappe all the way
    const Span before = intersected(-infinity, roots.t0), after = intersected(roots.t1, infinity);
    // The solid is convex, so one of the two is empty but for rounding at the apex.
    return before.t1 - before.t0 > after.t1 - after.t0 ? before : after;
}

}  // namespace cardioid::csg

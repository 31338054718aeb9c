#include <algorithm>
#include <cmath>

#include "csg/leaves/polynomial.hpp"
#include "csg/leaves/solvers.hpp"

namespace cardioid::csg {

int torus_roots(double R, double r, Vec3d o, Vec3d d, std::array<double, 4>& roots) {
    const double speed = length(d);
    const Vec3d w = d * (1 / speed);
    // The point closest to the centre, where the quartic is well conditioned; twice, since a far origin rounds the
    // first.
    double middle = -dot(o, w);
    Vec3d p = o + w * middle;
    const double rest = -dot(p, w);
    p += w * rest, middle += rest;
    // The search goes a little beyond the torus, so that its ends are outside and the number of roots is even.
    const double margin = 1e-9 * (R + r), outer = R + r + margin, half_height = r + margin;
    const double reach_square = outer * outer - dot(p, p);
    if (!(reach_square > 0)) return 0;
    double hi = std::sqrt(reach_square), lo = -hi;
    if (w.z != 0) {
        const double za = (-half_height - p.z) / w.z, zb = (half_height - p.z) / w.z;
        lo = std::max(lo, std::min(za, zb)), hi = std::min(hi, std::max(za, zb));
    } else if (std::abs(p.z) >= half_height) {
        return 0;
    }
    if (!(lo < hi)) return 0;
    // Through the hole: the distance from the axis is convex along the line, so largest at the ends.
    const auto axis_square = [&](double s) {
        const double x = p.x + s * w.x, y = p.y + s * w.y;
        return x * x + y * y;
    };
    const double hole = R - r - margin;
    if (hole > 0 && std::max(axis_square(lo), axis_square(hi)) < hole * hole) return 0;
    // (|x|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2) along x = p + s w; p.w = 0.
    const double k = dot(p, p) + R * R - r * r, four = 4 * R * R;
    const Polynomial<4> f{{k * k - four * (p.x * p.x + p.y * p.y), -2 * four * (p.x * w.x + p.y * w.y),
                           2 * k - four * (w.x * w.x + w.y * w.y), 0, 1}};
    int count = roots_between<4>(f, lo, hi, roots);
    if (count % 2 != 0) --count;
    for (int i = 0; i < count; ++i) {
        double& root = roots[static_cast<std::size_t>(i)];
        root = (root + middle) / speed;
    }
    return count;
}

}  // namespace cardioid::csg

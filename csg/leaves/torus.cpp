#include <algorithm>
#include <cmath>

#include "csg/leaves/solvers.hpp"

namespace cardioid::csg {
namespace {

/// A polynomial c[0] + c[1] x + ... + c[N] x^N.
template <int N>
struct Polynomial {
    std::array<double, N + 1> c;
    [[nodiscard]] double operator()(double x) const {
        double y = c[N];
        for (std::size_t i = N; i-- > 0;) y = y * x + c[i];
        return y;
    }
    [[nodiscard]] Polynomial<N - 1> derivative() const {
        Polynomial<N - 1> out;
        for (std::size_t i = 0; i < N; ++i) out.c[i] = c[i + 1] * static_cast<double>(i + 1);
        return out;
    }
};

/// The one root between lo and hi, where f changes sign: Newton steps kept inside a shrinking bracket.
template <int N>
double bracketed_root(const Polynomial<N>& f, double lo, double hi) {
    const auto slope = f.derivative();
    const bool rising = f(lo) < 0;
    double x = 0.5 * (lo + hi);
    for (int i = 0; i < 100; ++i) {
        const double y = f(x);
        ((y < 0) == rising ? lo : hi) = x;
        double next = x - y / slope(x);
        if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
        if (next == x || next == lo || next == hi) return next;
        if (std::abs(next - x) <= 1e-15 * (std::abs(x) + (hi - lo) * 1e-3)) return next;
        x = next;
    }
    return x;
}

/// Roots in [lo, hi], ascending, found between the roots of the derivative; a sign change between two of those
/// points is one root, so the parity is that of the signs at lo and hi. Returns how many.
template <int N>
int roots_between(const Polynomial<N>& f, double lo, double hi, std::array<double, 4>& roots) {
    std::array<double, 4> turns{};
    int turn_count = 0;
    if constexpr (N > 1) turn_count = roots_between<N - 1>(f.derivative(), lo, hi, turns);
    int count = 0;
    double x0 = lo, y0 = f(lo);
    for (int i = 0; i <= turn_count; ++i) {
        const double x1 = i < turn_count ? turns[static_cast<std::size_t>(i)] : hi, y1 = f(x1);
        if ((y0 < 0) != (y1 < 0)) roots[static_cast<std::size_t>(count++)] = bracketed_root(f, x0, x1);
        x0 = x1, y0 = y1;
    }
    return count;
}

}  // namespace

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

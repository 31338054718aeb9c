#pragma once
/// Real roots of polynomials of low degree, found between the roots of their derivatives.
#include <array>
#include <cmath>
#include <cstddef>

namespace cardioid::csg {

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

}  // namespace cardioid::csg

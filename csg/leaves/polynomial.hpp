#pragma once
/// Real roots of polynomials of low degree, found between the roots of their derivatives.
#include <algorithm>
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

/// The one root between lo and hi, where f changes sign: Newton steps kept inside a shrinking bracket, until one is no
/// longer than `close`, or rounding ends them.
template <int N>
double bracketed_root(const Polynomial<N>& f, double lo, double hi, double close = 0) {
    const auto slope = f.derivative();
    const bool rising = f(lo) < 0;
    double x = 0.5 * (lo + hi);
    for (int i = 0; i < 100; ++i) {
        const double y = f(x);
        ((y < 0) == rising ? lo : hi) = x;
        double next = x - y / slope(x);
        if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
        if (next == x || next == lo || next == hi) return next;
        if (std::abs(next - x) <= std::max(close, 1e-15 * (std::abs(x) + (hi - lo) * 1e-3))) return next;
        x = next;
    }
    return x;
}

/// Between turns f changes its sign at most once; calls `found` with the ends of each part where it does.
template <int N, typename Found>
void for_sign_changes(const Polynomial<N>& f, double lo, double hi, const std::array<double, 4>& turns, int turn_count,
                      const Found& found) {
    double x0 = lo, y0 = f(lo);
    for (int i = 0; i <= turn_count; ++i) {
        const double x1 = i < turn_count ? turns[static_cast<std::size_t>(i)] : hi, y1 = f(x1);
        if ((y0 < 0) != (y1 < 0)) found(x0, x1);
        x0 = x1, y0 = y1;
    }
}

/// Where the function that f is the derivative of may turn within [lo, hi], ascending; returns how many. Only to
/// half the digits: near a turn the function is flat, and what is off by 1e-8 of its place is off by 1e-16 of its
/// value.
template <int N>
int turns_between(const Polynomial<N>& f, double lo, double hi, std::array<double, 4>& turns) {
    int count = 0;
    const auto keep = [&](double x) {
        if (x > lo && x < hi) turns[static_cast<std::size_t>(count++)] = x;
    };
    if constexpr (N == 1) {
        keep(-f.c[0] / f.c[1]);
    } else if constexpr (N == 2) {
        const double half = 0.5 * f.c[1], discriminant = half * half - f.c[0] * f.c[2];
        if (!(discriminant > 0)) return 0;
        const double q = -(half + std::copysign(std::sqrt(discriminant), half));
        const double a = q / f.c[2], b = f.c[0] / q;
        keep(std::min(a, b)), keep(std::max(a, b));
    } else {
        std::array<double, 4> inner{};
        const int inner_count = turns_between<N - 1>(f.derivative(), lo, hi, inner);
        const double close = 1e-8 * (hi - lo);
        for_sign_changes(f, lo, hi, inner, inner_count,
                         [&](double x0, double x1) { keep(bracketed_root(f, x0, x1, close)); });
    }
    return count;
}

/// Roots in [lo, hi], ascending, found between the turns; a sign change between two of those points is one root, so the
/// parity is that of the signs at lo and hi. Returns how many.
template <int N>
int roots_between(const Polynomial<N>& f, double lo, double hi, std::array<double, 4>& roots) {
    std::array<double, 4> turns{};
    int turn_count = 0, count = 0;
    if constexpr (N > 1) turn_count = turns_between<N - 1>(f.derivative(), lo, hi, turns);
    for_sign_changes(f, lo, hi, turns, turn_count, [&](double x0, double x1) {
        roots[static_cast<std::size_t>(count++)] = bracketed_root(f, x0, x1);
    });
    return count;
}

}  // namespace cardioid::csg

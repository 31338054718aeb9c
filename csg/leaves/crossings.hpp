#pragma once
/// Where a function of one number changes sign, isolated by bounds of it and of its slope over intervals.
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace cardioid::csg {

/// What a function's values over an interval lie between.
struct Range {
    double lo, hi;
    [[nodiscard]] bool has_no_zero_within() const { return lo > 0 || hi < 0; }
    /// Of a slope: its function only rises, or only falls.
    [[nodiscard]] bool keeps_its_sign() const { return lo >= 0 || hi <= 0; }
};
inline constexpr Range any_range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
inline Range operator+(Range a, Range b) { return {a.lo + b.lo, a.hi + b.hi}; }
/// Of numbers that are not negative.
inline Range product_of_positive(Range a, Range b) { return {a.lo * b.lo, a.hi * b.hi}; }
inline Range operator*(Range a, double factor) {
    return factor < 0 ? Range{a.hi * factor, a.lo * factor} : Range{a.lo * factor, a.hi * factor};
}

/// The place in [a, b] where f, of different signs there, changes its sign: by regula falsi with halving of the end
/// that stays (Dowell and Jarratt 1971), then halves of what is left.
template <class Function>
double sign_change(const Function& f, double a, double fa, double b, double fb) {
    for (int i = 0; i < 100; ++i) {
        double x = i < 60 ? b - fb * (b - a) / (fb - fa) : 0.5 * (a + b);
        if (!(x > std::min(a, b) && x < std::max(a, b))) x = 0.5 * (a + b);
        if (x == a || x == b) break;
        const double y = f.value(x);
        if ((y < 0) != (fb < 0))
            a = b, fa = fb;
        else
            fa *= 0.5;
        const double step = std::abs(x - b);
        b = x, fb = y;
        if (y == 0 || (i > 2 && step <= 1e-16 * std::abs(b))) break;
    }
    return b;
}

/// Calls found(s) for each change of sign of f in [a, b], ascending; as many as the signs at a and b say, but for an
/// even number. An interval is halved until f cannot be 0 in it or only rises or falls: f.range(a, b) and
/// f.slope(a, b) are what value and slope lie between. Places closer than 2^-40 of the whole are not told apart.
template <class Function, class Found>
void each_sign_change(const Function& f, double a, double b, const Found& found) {
    constexpr int deepest = 40;
    struct Interval {
        double a, fa, b, fb;
        int depth;
    };
    std::array<Interval, deepest + 2> waiting{{{a, f.value(a), b, f.value(b), 0}}};
    std::size_t count = 1;
    while (count > 0) {
        const Interval i = waiting[--count];
        const double middle = 0.5 * (i.a + i.b);
        if (i.depth == deepest || !(middle > i.a && middle < i.b) || f.range(i.a, i.b).has_no_zero_within() ||
            f.slope(i.a, i.b).keeps_its_sign()) {
            if ((i.fa < 0) != (i.fb < 0)) found(sign_change(f, i.a, i.fa, i.b, i.fb));
            continue;
        }
        const double fm = f.value(middle);
        waiting[count++] = {middle, fm, i.b, i.fb, i.depth + 1};
        waiting[count++] = {i.a, i.fa, middle, fm, i.depth + 1};
    }
}

}  // namespace cardioid::csg

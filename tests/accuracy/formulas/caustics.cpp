/// Light by way of curved mirrors and lenses: at a point, the rays that lead there are found, and each gives its flux
/// over the area it is spread on. A ray that has left the mirrored circle of radius 1 at incidence b and gone s further
/// is spread by |m cos b - (m + d) s|, with m and d the turns of its last point and of its direction with b.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/accuracy/formulas/formulas.hpp"

namespace cardioid::test {

namespace {

constexpr double pi_d = std::numbers::pi;

/// Calls use(x) at every root of f between lo and hi that `steps` equal steps tell apart.
void each_root(const std::function<double(double)>& f, double lo, double hi, int steps,
               const std::function<void(double)>& use) {
    double a = lo, fa = f(lo);
    for (int i = 1; i <= steps; ++i) {
        const double b = lo + (hi - lo) * i / steps, fb = f(b);
        if (fa * fb < 0) {
            double left = a, right = b;
            for (int k = 0; k < 60; ++k) {
                const double middle = (left + right) / 2;
                (f(middle) * fa > 0 ? left : right) = middle;
            }
            use(left);
        }
        a = b, fa = fb;
    }
}

/// A ray of the plane that has just left the circle at `at` towards `heading` (angles).
struct Leaving {
    double at, heading;
    [[nodiscard]] double aside(double x, double y) const {
        return (x - std::cos(at)) * std::sin(heading) - (y - std::sin(at)) * std::cos(heading);
    }
    [[nodiscard]] double ahead(double x, double y) const {
        return (x - std::cos(at)) * std::cos(heading) + (y - std::sin(at)) * std::sin(heading);
    }
};

/// By the half ring, of a beam of normal irradiance 1 that travels at azimuth `turn`. Close to the ring light arrives
/// that has gone along it by several reflections, all of which must meet the half that is there.
double ring_of_beam(double x, double y, double turn, double elevation) {
    // A ray at the distance sin b from the middle goes 2 (pi / 2 - b) along the ring from one reflection to the next.
    const int reflections = 1 + static_cast<int>(std::min(pi_d / 2 / std::acos(std::min(std::hypot(x, y), 1.0)), 24.0));
    const double px = x * std::cos(turn) + y * std::sin(turn), py = y * std::cos(turn) - x * std::sin(turn);
    const double lo = std::max(-pi_d / 2, -pi_d / 2 - turn), hi = std::min(pi_d / 2, pi_d / 2 - turn);
    double sum = 0;
    for (int k = 1; k <= reflections; ++k) {
        const auto at = [](double b, int i) { return b + (i - 1) * (pi_d + 2 * b); };
        const auto leaving = [&](double b) { return Leaving{at(b, k), at(b, k) + pi_d + b}; };
        const auto all_meet = [&](double b) {
            for (int i = 2; i <= k; ++i)
                if (std::cos(at(b, i) + turn) < 0) return false;
            return true;
        };
        each_root([&](double b) { return leaving(b).aside(px, py); }, lo, hi, 2000,
                  [&](double b) {
                      const double s = leaving(b).ahead(px, py), chord = 2 * std::cos(b);
                      if (s > 0 && s <= chord && ((k - 1) * chord + s) * std::tan(elevation) < 2 && all_meet(b))
                          sum += std::sin(elevation) * std::cos(b) / std::abs((2 * k - 1) * std::cos(b) - 2 * k * s);
                  });
    }
    return sum;
}

/// x, y, half angle of the sun [deg]: direct light and the ring's; the mean over the sun's disc.
double ring_mirror(Arguments args) {
    const double x = args[0], y = args[1], half = args[2] * degree, direct = std::sin(pi_d / 4);
    if (half == 0) return direct + ring_of_beam(x, y, 0, pi_d / 4);
    constexpr int rings = 24, spokes = 24;
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < spokes; ++j) {
            const double c = 1 - (i + 0.5) / rings * (1 - std::cos(half)), s = std::sqrt(1 - c * c);
            const double phi = 2 * pi_d * (j + 0.5) / spokes, up = s * std::sin(phi), side = s * std::cos(phi);
            const double dx = (c + up) / std::numbers::sqrt2, dz = (up - c) / std::numbers::sqrt2;
            sum += ring_of_beam(x, y, std::atan2(side, dx), std::asin(-dz));
        }
    // Of an even disc a facing surface has sin^2 of the half angle, of which a direction has its solid angle's share.
    return direct + sum / (rings * spokes) * 2 * (1 - std::cos(half)) / std::pow(std::sin(half), 2);
}

/// x, y: a source of intensity 1 on the ring at (-1, 0), 0.5 over the floor; each reflection keeps a half. The half of
/// its light that goes into the wall comes back at once, as if from a second source of half the intensity.
double cardioid_curve(Arguments args) {
    constexpr double height = 0.5, kept = 0.5;
    constexpr int reflections = 24;
    const double x = args[0], y = args[1];
    double sum = height / std::pow((x + 1) * (x + 1) + y * y + height * height, 1.5);
    for (int k = 1; k <= reflections; ++k) {
        const auto leaving = [k](double b) {
            const double at = 2 * k * b - (k - 1) * pi_d;
            return Leaving{at, at + pi_d + b};
        };
        each_root([&](double b) { return leaving(b).aside(x, y); }, -pi_d / 2, pi_d / 2, 4000,
                  [&](double b) {
                      const double s = leaving(b).ahead(x, y), chord = 2 * std::cos(b), way = k * chord + s;
                      if (s > 0 && s < chord)
                          sum += std::pow(kept, k) * height * way /
                                 (std::pow(way * way + height * height, 1.5) * std::abs(k * chord - (2 * k + 1) * s));
                  });
    }
    return (1 + kept) * sum;
}

/// Index, distance of the floor from the ball's centre, radius q: mean irradiance of the disc of radius q.
double ball_lens(Arguments args) {
    constexpr int rays = 100'000;
    const double index = args[0], floor = args[1], q = args[2];
    double sum = 0;
    for (int i = 0; i < rays; ++i) {
        const double outside = std::asin(std::sqrt((i + 0.5) / rays)), inside = std::asin(std::sin(outside) / index);
        const double leaves = 2 * inside - outside;  // the angle at the centre, off the axis
        const double off = std::sin(leaves) + (floor - std::cos(leaves)) * std::tan(2 * (inside - outside));
        if (std::abs(off) < q) sum += std::pow(1 - unpolarised(std::cos(outside), index), 2);
    }
    return sum / rays / (q * q);
}

/// Index, distance r from the foot of a source of intensity 1 that stands 1 over water of depth 1.
double water_point(Arguments args) {
    const double index = args[0], r = args[1];
    if (r == 0) return (1 - unpolarised(1, index)) / std::pow(1 + 1 / index, 2);
    const auto inside = [&](double a) { return std::asin(std::sin(a) / index); };
    double E = 0;
    each_root([&](double a) { return std::tan(a) + std::tan(inside(a)) - r; }, 0, pi_d / 2 - 1e-9, 1000,
              [&](double a) {
                  const double b = inside(a);
                  const double spread = 1 / std::pow(std::cos(a), 2) + std::cos(a) / (index * std::pow(std::cos(b), 3));
                  E += (1 - unpolarised(std::cos(a), index)) * std::sin(a) / (r * spread);
              });
    return E;
}

constexpr Formula formulas[] = {{"ring_mirror", 3, ring_mirror},
                                {"cardioid", 2, cardioid_curve},
                                {"ball_lens", 3, ball_lens},
                                {"water_point", 2, water_point}};

}  // namespace

std::span<const Formula> caustic_formulas() { return formulas; }

}  // namespace cardioid::test

/// Form factors of Howell, "A catalog of radiation heat transfer configuration factors", and Lambert's formula.
#include <cmath>
#include <numbers>
#include <vector>

#include "rt_core/api/math.hpp"
#include "tests/accuracy/formulas/formulas.hpp"

namespace cardioid::test {

namespace {

constexpr double pi_d = std::numbers::pi;

Vec3d vector(Arguments args, std::size_t first) { return {args[first], args[first + 1], args[first + 2]}; }

/// Unit squares, d apart (C-11).
double opposed_squares(Arguments args) {
    const double x = 1 / args[0], w = std::sqrt(1 + x * x);
    return 2 / (pi_d * x * x) *
           (std::log(w * w / std::sqrt(1 + 2 * x * x)) + 2 * x * w * std::atan(x / w) - 2 * x * std::atan(x));
}

/// From the lying rectangle of width w to the standing one of height h on their common edge of length l (C-14).
double perpendicular_rectangles(Arguments args) {
    const double h = args[0] / args[2], w = args[1] / args[2], h2 = h * h, w2 = w * w, d = std::hypot(h, w);
    const double logs = std::log((1 + w2) * (1 + h2) / (1 + w2 + h2)) +
                        w2 * std::log(w2 * (1 + w2 + h2) / ((1 + w2) * (w2 + h2))) +
                        h2 * std::log(h2 * (1 + w2 + h2) / ((1 + h2) * (w2 + h2)));
    return (w * std::atan(1 / w) + h * std::atan(1 / h) - d * std::atan(1 / d) + logs / 4) / (pi_d * w);
}

/// From a disc of radius r1 to one of radius r2, h apart on one axis (C-41).
double coaxial_discs(Arguments args) {
    const double a = args[0] / args[2], b = args[1] / args[2], x = 1 + (1 + b * b) / (a * a);
    return (x - std::sqrt(x * x - 4 * b * b / (a * a))) / 2;
}

/// From a point to a disc of radius r in a parallel plane h away, a off its axis (B-13).
double disc_lamp(Arguments args) {
    const double r2 = args[0] * args[0], h2 = args[1] * args[1], a2 = args[2] * args[2], sum = a2 + h2 + r2;
    return (1 - (a2 + h2 - r2) / std::sqrt(sum * sum - 4 * r2 * a2)) / 2;
}

double ball_lamp(Arguments args) { return args[0] * args[0] / (args[1] * args[1]) * std::cos(args[2] * degree); }

/// The part of the polygon above the horizon of n.
std::vector<Vec3d> clipped(const std::vector<Vec3d>& polygon, Vec3d n) {
    std::vector<Vec3d> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double ha = dot(a, n), hb = dot(b, n);
        if (ha >= 0) kept.push_back(a);
        if (ha * hb < 0) kept.push_back(a + (b - a) * (ha / (ha - hb)));
    }
    return kept;
}

/// From the point p with normal n to the rectangle at a corner c with the edges u, v: arguments c, u, v, p, n (Lambert
/// 1760, in the form of Baum, Rushmeier and Winget 1989).
double rectangle_lamp(Arguments args) {
    const Vec3d p = vector(args, 9), n = vector(args, 12), c = vector(args, 0) - p, u = vector(args, 3),
                v = vector(args, 6);
    const std::vector<Vec3d> seen = clipped({c, c + u, c + u + v, c + v}, n);
    double sum = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Vec3d a = seen[i], b = seen[(i + 1) % seen.size()], across = cross(a, b);
        if (length(across) > 0) sum += std::atan2(length(across), dot(a, b)) * dot(across, n) / length(across);
    }
    return std::abs(sum) / (2 * pi_d);
}

/// A small diffuse lamp of intensity 1000, 3 over the floor.
double cie_point(Arguments args) {
    const double d2 = args[0] * args[0] + args[1] * args[1] + 9;
    return 9000 / (d2 * d2);
}

constexpr Formula formulas[] = {{"opposed_squares", 1, opposed_squares},
                                {"perpendicular_rectangles", 3, perpendicular_rectangles},
                                {"coaxial_discs", 3, coaxial_discs},
                                {"disc_lamp", 3, disc_lamp},
                                {"ball_lamp", 3, ball_lamp},
                                {"rectangle_lamp", 15, rectangle_lamp},
                                {"cie_point", 2, cie_point}};

}  // namespace

std::span<const Formula> form_factor_formulas() { return formulas; }

}  // namespace cardioid::test

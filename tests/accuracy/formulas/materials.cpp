/// What share of light a material sends back from one direction, by integrals of its published definition.
#include <cmath>
#include <complex>
#include <numbers>

#include "tests/accuracy/formulas/formulas.hpp"

namespace cardioid::test {

namespace {

/// Index n + i k, angle [deg], with complex numbers throughout (Born and Wolf, 14.2).
double conductor(Arguments args) {
    const std::complex<double> m(args[0], args[1]);
    const double c = std::cos(args[2] * degree);
    const std::complex<double> t = std::sqrt(m * m - (1 - c * c));
    const double s = std::norm((c - t) / (c + t)), p = std::norm((m * m * c - t) / (m * m * c + t));
    return (s + p) / 2;
}

/// Reflectance of the body, index, angle [deg]: a smooth coat over a diffuse body, with all reflections between them.
double plastic(Arguments args) {
    const double rho = args[0], index = args[1], first = unpolarised(std::cos(args[2] * degree), index);
    const double outside = over_cosines([&](double c) { return unpolarised(c, index); });
    const double inside = over_cosines([&](double c) { return unpolarised(c, 1 / index); });
    return first + (1 - first) * (1 - outside) * rho / (index * index * (1 - rho * inside));
}

/// kd, ks, exponent n, angle [deg]: kd + ks (n + 2) / (2 pi) times the integral of cos^n alpha cos theta (Lafortune and
/// Willems 1994), over alpha and the angle around the mirrored direction.
double phong(Arguments args) {
    constexpr int steps = 1000;
    const double n = args[2], c = std::cos(args[3] * degree), s = std::sin(args[3] * degree);
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double cos_alpha = std::pow((i + 0.5) / steps, 1 / (n + 1));
        const double sin_alpha = std::sqrt(1 - cos_alpha * cos_alpha);
        for (int j = 0; j < steps; ++j)
            sum += std::max(0.0, cos_alpha * c - sin_alpha * s * std::cos(2 * std::numbers::pi * (j + 0.5) / steps));
    }
    return args[0] + args[1] * (n + 2) / (n + 1) * sum / (steps * steps);
}

constexpr Formula formulas[] = {{"conductor", 3, conductor}, {"plastic", 3, plastic}, {"phong", 4, phong}};

}  // namespace

std::span<const Formula> material_formulas() { return formulas; }

}  // namespace cardioid::test

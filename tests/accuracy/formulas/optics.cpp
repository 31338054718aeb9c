/// Plates and water: Fresnel's, Snell's and Beer's laws.
#include <cmath>
#include <numbers>

#include "tests/accuracy/formulas/formulas.hpp"

namespace cardioid::test {

namespace {

constexpr double thickness = 0.5;

double dot_of(Arguments a, std::size_t first, double x, double y, double z) {
    return a[first] * x + a[first + 1] * y + a[first + 2] * z;
}

double cosine_inside(double cosine, double index) { return std::sqrt(1 - (1 - cosine * cosine) / (index * index)); }

/// All reflections between the faces of a plate, each of unpolarised light; depth is its absorption times its
/// thickness.
double transmittance(double cosine, double index, double depth) {
    const double r = unpolarised(cosine, index), t = std::exp(-depth / cosine_inside(cosine, index));
    return (1 - r) * (1 - r) * t / (1 - r * r * t * t);
}

/// Index, angle [deg], absorption.
double slab(Arguments args) { return transmittance(std::cos(args[1] * degree), args[0], args[2] * thickness); }

/// Index and absorption of a pane 6 mm thick over an opening of 4 x 4 that is 3 over the floor, then point and normal:
/// irradiance of a sky of radiance 100 / pi.
double glazed_roof(Arguments args) {
    constexpr int steps = 800;
    constexpr double edge = 4, height = 3, pane = 0.006;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double x = edge * ((i + 0.5) / steps - 0.5) - args[2], y = edge * ((j + 0.5) / steps - 0.5) - args[3];
            const double z = height - args[4], d2 = x * x + y * y + z * z, d = std::sqrt(d2);
            const double facing = dot_of(args, 5, x, y, z) / d;
            if (facing > 0) sum += transmittance(z / d, args[0], args[1] * pane) * facing * z / (d2 * d);
        }
    return 100 / std::numbers::pi * sum * edge * edge / (steps * steps);
}

/// Index, absorption of a layer of depth 1 under even light.
double water(Arguments args) {
    return std::numbers::pi * over_cosines([&](double c) {
               return (1 - unpolarised(c, args[0])) * std::exp(-args[1] / cosine_inside(c, args[0]));
           });
}

/// Absorption, angle [deg].
double beer(Arguments args) { return std::exp(-args[0] * thickness / std::cos(args[1] * degree)); }

/// 2 pi E3(absorption times thickness), by its definition.
double exponential_integral(Arguments args) {
    return std::numbers::pi * over_cosines([&](double c) { return std::exp(-args[0] * thickness / c); });
}

/// Absorption and place on a floor 1 under a point of intensity 1.
double fog(Arguments args) {
    const double d = std::sqrt(1 + args[1] * args[1] + args[2] * args[2]);
    return std::exp(-args[0] * d) / (d * d * d);
}

constexpr Formula formulas[] = {{"slab", 3, slab},
                                {"glazed_roof", 8, glazed_roof},
                                {"water", 2, water},
                                {"beer", 2, beer},
                                {"exponential_integral", 1, exponential_integral},
                                {"fog", 3, fog}};

}  // namespace

std::span<const Formula> optics_formulas() { return formulas; }

}  // namespace cardioid::test

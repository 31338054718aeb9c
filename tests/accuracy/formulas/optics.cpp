/// Plates and water: Fresnel's, Snell's and Beer's laws.
#include <cmath>
#include <numbers>

#include "tests/accuracy/formulas/formulas.hpp"

namespace cardioid::test {

namespace {

constexpr double thickness = 0.5;

double cosine_inside(double cosine, double index) { return std::sqrt(1 - (1 - cosine * cosine) / (index * index)); }

/// Index, angle [deg], absorption: all reflections between the faces, each of unpolarised light.
double slab(Arguments args) {
    const double c = std::cos(args[1] * degree), r = unpolarised(c, args[0]);
    const double t = std::exp(-args[2] * thickness / cosine_inside(c, args[0]));
    return (1 - r) * (1 - r) * t / (1 - r * r * t * t);
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
                                {"water", 2, water},
                                {"beer", 2, beer},
                                {"exponential_integral", 1, exponential_integral},
                                {"fog", 3, fog}};

}  // namespace

std::span<const Formula> optics_formulas() { return formulas; }

}  // namespace cardioid::test

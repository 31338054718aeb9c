/// Diffuse light that goes to and fro: spheres, where every place sees all others alike, and the cube by radiosity.
#include <cmath>
#include <numbers>

#include "tests/accuracy/formulas/cube_radiosity.hpp"
#include "tests/accuracy/formulas/formulas.hpp"

namespace cardioid::test {

namespace {

double constant(Arguments args) { return args[0]; }
double furnace(Arguments args) { return 1 / (1 - args[0]); }
double octants(Arguments args) { return std::numbers::pi / (1 - (args[0] + args[1]) / 2); }
/// rho, share f of the port; the source's power is the sphere's area.
double integrating_sphere(Arguments args) { return 1 / (1 - args[0] * (1 - args[1])); }

/// Mean irradiance of the disc that closes the port: what leaves, f of the irradiance times 4 pi, over its area.
double port(Arguments args) {
    const double z = 1 - 2 * args[1];
    return args[1] * integrating_sphere(args) * 4 / (1 - z * z);
}

/// rho1, rho2, which of the plates: 1 is the one that shines.
double plates(Arguments args) {
    const double upper = 1 / (1 - args[0] * args[1]);
    return args[2] == 2 ? upper : args[1] * upper;
}

/// r1 / r2, rho1, rho2, which: 1 is the ball, which shines, 2 the shell around it.
double concentric_spheres(Arguments args) {
    const double seen = args[0] * args[0];  // of the ball, by the shell
    const double shell = seen / (1 - seen * args[1] * args[2] - (1 - seen) * args[2]);
    return args[3] == 2 ? shell : args[2] * shell;
}

/// rho, f, which: E1 = (1 - f) (1 + rho E1) + f rho E2, E2 = (1 - f) rho E2 + f (1 + rho E1).
double keyhole(Arguments args) {
    const double rho = args[0], f = args[1], own = 1 - (1 - f) * rho, other = f * rho;
    const double divisor = own * own - other * other;
    return args[2] == 1 ? ((1 - f) * own + f * other) / divisor : (f * own + (1 - f) * other) / divisor;
}

/// Reflectances of floor, ceiling, x = 0, x = 1 and the other two, then face and point.
double cube(Arguments args) {
    return cube_irradiance({args[0], args[1], args[2], args[3], args[4], args[4]}, {0, 1, 0, 0, 0, 0}, 0,
                           static_cast<int>(args[5]), {args[6], args[7], args[8]});
}

constexpr double cie_flux = 10'000, cie_area = 96;

double cie_cube_mean(Arguments args) { return cie_flux / cie_area / (1 - args[0]); }
/// rho and a point of the floor as shares of its edges.
double cie_cube(Arguments args) {
    const double rho = args[0];
    return cube_irradiance({rho, rho, rho, rho, rho, rho}, {}, cie_flux / 16, 0, {args[1], args[2], 0});
}

constexpr Formula formulas[] = {{"constant", 1, constant},
                                {"furnace", 1, furnace},
                                {"octants", 2, octants},
                                {"integrating_sphere", 2, integrating_sphere},
                                {"port", 2, port},
                                {"plates", 3, plates},
                                {"concentric_spheres", 4, concentric_spheres},
                                {"keyhole", 3, keyhole},
                                {"cube", 9, cube},
                                {"cie_cube_mean", 1, cie_cube_mean},
                                {"cie_cube", 3, cie_cube}};

}  // namespace

std::span<const Formula> interreflection_formulas() { return formulas; }

}  // namespace cardioid::test

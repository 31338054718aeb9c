/// Skies of the CIE by the formula of ISO 15469:2004 and its table, summed over the sky or over an opening.
#include <cmath>
#include <numbers>

#include "tests/accuracy/formulas/formulas.hpp"

namespace cardioid::test {

namespace {

constexpr double pi_d = std::numbers::pi;

/// Radiance over that of the zenith towards the unit vector x, y, z, with the sun over +x.
class Sky {
public:
    Sky(double type, double elevation)
        : row_(rows[static_cast<std::size_t>(type) - 1]),
          sun_x_(std::cos(elevation * degree)),
          sun_z_(std::sin(elevation * degree)),
          zenith_(whole(0, 1)) {}
    [[nodiscard]] double operator()(double x, double z) const { return whole(x, z) / zenith_; }
    /// What the standard divides by: without it, the even sky alone has radiance 1 overhead.
    [[nodiscard]] double zenith() const { return zenith_; }

private:
    [[nodiscard]] double whole(double x, double z) const {
        const auto& [a, b, c, d, e] = row_;
        const double cosine = std::min(1.0, x * sun_x_ + z * sun_z_), chi = std::acos(std::max(-1.0, cosine));
        return (1 + a * std::exp(b / z)) * (1 + c * (std::exp(d * chi) - std::exp(d * pi_d / 2)) + e * cosine * cosine);
    }
    struct Row {
        double a, b, c, d, e;
    };
    static constexpr Row rows[15] = {{4, -.7, 0, -1, 0},       {4, -.7, 2, -1.5, .15},  {1.1, -.8, 0, -1, 0},
                                     {1.1, -.8, 2, -1.5, .15}, {0, -1, 0, -1, 0},       {0, -1, 2, -1.5, .15},
                                     {0, -1, 5, -2.5, .3},     {0, -1, 10, -3, .45},    {-1, -.55, 2, -1.5, .15},
                                     {-1, -.55, 5, -2.5, .3},  {-1, -.55, 10, -3, .45}, {-1, -.32, 10, -3, .45},
                                     {-1, -.32, 16, -3, .3},   {-1, -.15, 16, -3, .3},  {-1, -.15, 24, -2.8, .15}};

    Row row_;
    double sun_x_, sun_z_, zenith_;
};

/// Irradiance of a plane with normal nx, ny, nz over the zenith's radiance.
double on_plane(const Sky& sky, double nx, double ny, double nz) {
    constexpr int steps = 700;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double z = (i + 0.5) / steps, r = std::sqrt(1 - z * z), turn = 2 * pi_d * (j + 0.5) / steps;
            const double x = r * std::cos(turn), y = r * std::sin(turn);
            sum += sky(x, z) * std::max(0.0, nx * x + ny * y + nz * z);
        }
    return sum * 2 * pi_d / (steps * steps);
}

/// Type, the sun's elevation [deg], normal.
double cie_sky(Arguments args) { return on_plane({args[0], args[1]}, args[2], args[3], args[4]); }

/// The same on the ground for a sky that is not divided by what it is overhead: the integral of f(chi) phi(Z) cos Z.
double cie_sky_undivided(Arguments args) {
    const Sky sky(args[0], args[1]);
    return on_plane(sky, 0, 0, 1) * sky.zenith();
}

/// Type, elevation, edge of an opening 3 over the floor, point, normal: daylight factor [%].
double cie_roof(Arguments args) {
    constexpr int steps = 500;
    constexpr double height = 3;
    const Sky sky(args[0], args[1]);
    const double edge = args[2], z = height - args[5];
    double sum = 0;
    // Points crowd at the edges, t -> 3 t^2 - 2 t^3, where the opening is near a point of the wall.
    const auto crowded = [&](int i) {
        const double t = (i + 0.5) / steps;
        return std::pair{edge * (t * t * (3 - 2 * t) - 0.5), edge / steps * 6 * t * (1 - t)};
    };
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const auto [u, du] = crowded(i);
            const auto [v, dv] = crowded(j);
            const double x = u - args[3], y = v - args[4], d2 = x * x + y * y + z * z, d = std::sqrt(d2);
            const double facing = (args[6] * x + args[7] * y + args[8] * z) / d;
            if (facing > 0) sum += sky(x / d, z / d) * facing * z / (d2 * d) * du * dv;
        }
    return 100 * sum / on_plane(sky, 0, 0, 1);
}

constexpr Formula formulas[] = {
    {"cie_sky", 5, cie_sky}, {"cie_sky_undivided", 2, cie_sky_undivided}, {"cie_roof", 9, cie_roof}};

}  // namespace

std::span<const Formula> sky_formulas() { return formulas; }

}  // namespace cardioid::test

#include "shaders/lights/cie_sky.hpp"

namespace cardioid::shaders {

namespace {

struct Type {
    double a, b, c, d, e;
};

/// ISO 15469:2004, table 1.
constexpr Type types[15] = {
    {4, -0.7, 0, -1, 0},           // overcast, steep gradation towards the zenith, the same all around
    {4, -0.7, 2, -1.5, 0.15},      // overcast, steep gradation, slightly brighter towards the sun
    {1.1, -0.8, 0, -1, 0},         // overcast, moderate gradation, the same all around
    {1.1, -0.8, 2, -1.5, 0.15},    // overcast, moderate gradation, slightly brighter towards the sun
    {0, -1, 0, -1, 0},             // even
    {0, -1, 2, -1.5, 0.15},        // partly cloudy, no gradation, slightly brighter towards the sun
    {0, -1, 5, -2.5, 0.3},         // partly cloudy, no gradation, brighter around the sun
    {0, -1, 10, -3, 0.45},         // partly cloudy, no gradation, a corona
    {-1, -0.55, 2, -1.5, 0.15},    // partly cloudy, the sun hidden
    {-1, -0.55, 5, -2.5, 0.3},     // partly cloudy, brighter around the sun
    {-1, -0.55, 10, -3, 0.45},     // white-blue, a corona
    {-1, -0.32, 10, -3, 0.45},     // clear, little turbidity
    {-1, -0.32, 16, -3, 0.3},      // clear, polluted
    {-1, -0.15, 16, -3, 0.3},      // cloudless and turbid, a wide corona
    {-1, -0.15, 24, -2.8, 0.15}};  // white-blue and turbid, a wide corona

constexpr std::size_t columns = 256, rows = 128, fine = 4;

}  // namespace

CieSky::CieSky(int type, double elevation) : sun_{std::cos(elevation), 0, std::sin(elevation)} {
    const Type& of = types[type - 1];
    a_ = of.a, b_ = of.b, c_ = of.c, d_ = of.d, e_ = of.e;
    zenith_ = gradation(1) * indicatrix(sun_.z);
    std::vector<float> weights(columns * rows);
    const auto sky = [&](double x, double y) {
        const double turn = 2 * std::numbers::pi * (0.5 - x), sine = std::sin(std::numbers::pi * y);
        return relative({sine * std::cos(turn), sine * std::sin(turn), std::cos(std::numbers::pi * y)});
    };
    for (std::size_t y = 0; y < rows / 2; ++y)
        for (std::size_t x = 0; x < columns; ++x) {
            // The middle of a cell is enough for drawing; the integral takes four points of it.
            const double top = static_cast<double>(y) / rows, left = static_cast<double>(x) / columns;
            weights[y * columns + x] = static_cast<float>(sky(left + 0.5 / columns, top + 0.5 / rows));
            for (std::size_t k = 0; k < fine; ++k) {
                const double part = (static_cast<double>(k) + 0.5) / fine,
                             zenith = std::numbers::pi * (top + part / rows);
                integral_ += sky(left + part / columns, top + part / rows) * std::sin(zenith);
            }
        }
    integral_ *= 2 * std::numbers::pi * std::numbers::pi / (columns * rows * fine);
    density_ = LatLongDensity(columns, rows, weights);
}

double CieSky::relative(Vec3d d) const noexcept {
    if (!(d.z > 0)) return 0;
    const Vec3d unit = normalize(d);
    return gradation(unit.z) * indicatrix(dot(unit, sun_)) / zenith_;
}

double CieSky::gradation(double cos_zenith) const noexcept { return 1 + a_ * std::exp(b_ / cos_zenith); }

double CieSky::indicatrix(double cos_sun) const noexcept {
    const double angle = std::acos(std::clamp(cos_sun, -1.0, 1.0));
    return 1 + c_ * (std::exp(d_ * angle) - std::exp(d_ * std::numbers::pi / 2)) + e_ * cos_sun * cos_sun;
}

}  // namespace cardioid::shaders

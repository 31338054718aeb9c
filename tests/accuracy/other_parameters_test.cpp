/// Points and parameters that are not in the table, drawn at random: the scenes are right wherever their formulas are.
#include <fmt/format.h>
#include <numbers>

#include "tests/accuracy/expect_found.hpp"
#include "tests/accuracy/formulas/formulas.hpp"

namespace cardioid::test {
namespace {

/// Draws parameters, with three decimals so that the scene's text says all of them.
class Draw {
public:
    explicit Draw(std::uint32_t seed) : sampler_(seed, Purpose::test, 1, 0) {}
    double between(double lo, double hi) {
        return std::round((lo + (hi - lo) * static_cast<double>(sampler_.next())) * 1000) / 1000;
    }

private:
    Sampler sampler_;
};

KnownValue value(const char* scene, const char* formula, std::vector<double> args, double times = 1) {
    KnownValue made;
    made.section = "drawn", made.scene = scene, made.formula = formula, made.args = std::move(args);
    made.name = fmt::format("{} of {}", formula, fmt::join(made.args, ", "));
    made.expected = times * known_formula(formula, made.args);
    return made;
}

void set_point(KnownValue& made, Vec3d p, Vec3d along, Quantity what = Quantity::irradiance) {
    made.place.origin = p, made.place.along = along, made.place.what = what;
}

KnownValue opposed_squares(Draw& draw) {
    const double d = draw.between(0.2, 4), x = draw.between(-0.5, 0.5), y = draw.between(-0.5, 0.5);
    KnownValue made =
        value("direct/opposed_squares.csg", "rectangle_lamp", {-0.5, -0.5, d, 1, 0, 0, 0, 1, 0, x, y, 0, 0, 0, 1});
    made.change = {{"translate([0, 0, 1])", fmt::format("translate([0, 0, {}])", d)}};
    set_point(made, {x, y, 0}, {0, 0, 1});
    return made;
}

KnownValue disc_lamp(Draw& draw) {
    const double r = draw.between(0.2, 2), h = draw.between(0.4, 2), a = draw.between(0, 2);
    KnownValue made = value("direct/discs.csg", "disc_lamp", {r, h, a});
    made.change = {{"0, 1]) disk_light(1", fmt::format("0, {}]) disk_light({}", h, r)}};
    set_point(made, {0, a, 0}, {0, 0, 1});
    return made;
}

KnownValue ball_lamp(Draw& draw) {
    const double r = draw.between(0.1, 0.8), d = draw.between(1, 4), angle = draw.between(0, 35);
    KnownValue made = value("direct/ball_lamp.csg", "ball_lamp", {r, d, angle});
    made.change = {{"sphere_light(0.5", fmt::format("sphere_light({}", r)}};
    set_point(made, {d, 0, 0}, {-std::cos(angle * degree), 0, std::sin(angle * degree)});
    return made;
}

KnownValue integrating_sphere(Draw& draw) {
    const double rho = draw.between(0.1, 0.7), f = draw.between(0.01, 0.15);
    KnownValue made = value("rooms/integrating_sphere.csg", "integrating_sphere", {rho, f});
    made.change = {{"reflectance = 0.9", fmt::format("reflectance = {}", rho)},
                   {"2.18])", fmt::format("{}])", 2.2 - 2 * f)}};
    const double z = draw.between(-0.9, 0.6), s = std::sqrt(1 - z * z);
    set_point(made, {0, s, z}, {0, -s, -z});
    return made;
}

KnownValue plates(Draw& draw) {
    const double lower = draw.between(0, 0.7), upper = draw.between(0.1, 0.7);
    KnownValue made = value("rooms/plates.csg", "plates", {lower, upper, 2});
    const auto plate = [](const char* name, double rho) {
        return fmt::format("\"{}\", kind = \"diffuse\", reflectance = {}", name, rho);
    };
    made.change = {{plate("lower", 0.5), plate("lower", lower)}, {plate("upper", 0.5), plate("upper", upper)}};
    set_point(made, {draw.between(0.1, 0.9), draw.between(0.1, 0.9), 1}, {0, 0, -1});
    return made;
}

KnownValue concentric_spheres(Draw& draw) {
    const double r = draw.between(0.3, 0.9), inner = draw.between(0, 0.9), outer = draw.between(0.1, 0.6);
    KnownValue made = value("rooms/concentric_spheres.csg", "concentric_spheres", {r, inner, outer, 2});
    made.change = {{"reflectance = 0.5", fmt::format("reflectance = {}", inner)},
                   {"reflectance = 0.8", fmt::format("reflectance = {:.4f}", outer)},
                   {"sphere(0.5)", fmt::format("sphere({})", r)}};
    set_point(made, {0, 0.6, -0.8}, {0, -0.6, 0.8});
    return made;
}

KnownValue slab(Draw& draw) {
    const double n = draw.between(1.2, 2.4), angle = draw.between(0, 70), absorption = draw.between(0, 1);
    KnownValue made = value("optics/slab.csg", "slab", {n, angle, absorption});
    made.change = {{"ior = 1.52", fmt::format("ior = {}", n)},
                   {"absorption = 0", fmt::format("absorption = {}", absorption)}};
    set_point(made, {0, 0, -1}, {std::sin(angle * degree), 0, std::cos(angle * degree)}, Quantity::radiance);
    return made;
}

KnownValue fog(Draw& draw) {
    const double absorption = draw.between(0, 3), x = draw.between(-0.9, 0.9), y = draw.between(-0.9, 0.9);
    KnownValue made = value("optics/fog.csg", "fog", {absorption, x, y});
    made.change = {{"absorption = 0.7", fmt::format("absorption = {}", absorption)}};
    set_point(made, {x, y, -1}, {0, 0, 1});
    return made;
}

KnownValue water(Draw& draw) {
    const double n = draw.between(1.1, 1.8), absorption = draw.between(0, 0.6);
    KnownValue made = value("optics/water.csg", "water", {n, absorption});
    made.change = {{"ior = 1.333", fmt::format("ior = {}", n)},
                   {"absorption = 0", fmt::format("absorption = {}", absorption)}};
    set_point(made, {0.1, 0.2, 0}, {0, 0, 1});
    return made;
}

TEST(DrawnParameters, GiveWhatTheFormulasSay) {
    constexpr std::uint32_t draws = 2;
    for (std::uint32_t i = 0; i < draws; ++i) {
        Draw draw(100 + i);
        for (const auto make : {opposed_squares, disc_lamp, ball_lamp, integrating_sphere, plates, concentric_spheres,
                                slab, fog, water}) {
            const KnownValue known = make(draw);
            Bench bench(known, "path", 1 + i, Params("test"));
            expect_found(known, bench, {.noise = 0.0028, .most_samples = 1 << 22}, 0);
        }
    }
}

}  // namespace
}  // namespace cardioid::test

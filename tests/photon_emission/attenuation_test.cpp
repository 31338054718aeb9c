#include <gtest/gtest.h>

#include "emission_kit.hpp"

#include "rt_core/api/bsdf.hpp"

namespace cardioid {
namespace {

using test::SceneKit;

/// A floor at z = 0 of such a material, under a lamp of 1 W/sr at the height.
SceneKit under_a_lamp(double height, std::initializer_list<std::pair<const char*, std::vector<double>>> values) {
    SceneKit kit;
    kit.root(kit.box({-60, -60, -1}, {60, 60, 0}, kit.material("floor", "phong", values)));
    kit.light("point_light", {{"intensity", {1, 1, 1}}}, Affine::translation({0, 0, height}));
    return kit;
}

/// Radiance of the floor below the lamp, by its direct light.
double direct(double height, std::initializer_list<std::pair<const char*, std::vector<double>>> values) {
    const SceneKit kit = under_a_lamp(height, values);
    const CommittedScene world = kit.commit();
    const Ray ray{{0, 0, height / 2}, {0, 0, -1}};
    const SurfacePoint point = world.surface(ray, world.intersect(ray));
    BsdfMemory memory;
    Sampler sampler(1, Purpose::test, 0, 0);
    return double{world.direct(point, *world.bsdf(point, memory), {0, 0, 1}, sampler).g};
}

/// Irradiance that photons show below the lamp, of the true one.
double by_photons(double height) {
    const SceneKit kit = under_a_lamp(height, {{"specular", {0}}});
    const photon::Shot shot = test::shoot(kit.commit(), 400'000);
    const double r = 0.3 * height;
    double flux = 0;
    for (const photon::Photon& p : shot.photons) {
        const Vec3d at = test::place(shot, p);
        if (p.way == photon::Way::direct && at.x * at.x + at.y * at.y <= r * r) flux += double{test::flux(shot, p).g};
    }
    return flux / (2 * std::numbers::pi * (1 - height / std::hypot(height, r)));
}

// Note [9] of the report has direct light fall off as 1/(a + b d + c d^2), "as photon mapping does". Photons show the
// inverse square. What BRL-CAD's a = 0.1, b = 1, c = 0.01 make of it, once both agree at a distance of 1:
TEST(Attenuation, OfTheReportIsNotWhatPhotonsShow) {
    const double one = direct(1, {{"specular", {0}}, {"attenuation", {0.1, 1, 0.01}}}) / direct(1, {{"specular", {0}}});
    const std::pair<double, double> wrong[] = {{0.1, 0.055}, {0.5, 0.461}, {2, 2.07}, {8, 8.13}, {16, 15.2}};
    for (const auto& [d, ratio] : wrong) {
        const double right = direct(d, {{"specular", {0}}});
        EXPECT_NEAR(right * d * d / direct(1, {{"specular", {0}}}), 1, 1e-4) << d;
        EXPECT_NEAR(direct(d, {{"specular", {0}}, {"attenuation", {0.1, 1, 0.01}}}) / right / one / ratio, 1, 0.01)
            << d;
        EXPECT_NEAR(by_photons(d), 1, 0.02) << d;
    }
}

// ... and what 1/(p + d^2) with p = 0.001 does close by.
TEST(Attenuation, WithASmallTermIsWrongCloseBy) {
    const double right = direct(0.1, {{"specular", {0}}});
    EXPECT_NEAR(direct(0.1, {{"specular", {0}}, {"attenuation_p", {1e-3}}}) / right, 1 / 1.1, 1e-3);
}

}  // namespace
}  // namespace cardioid

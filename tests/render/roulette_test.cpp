#include "rt_core/render/lighting/roulette.hpp"

#include <gtest/gtest.h>

#include "path_kit.hpp"

namespace cardioid {
namespace {

constexpr int longest = 1'000'000;

TEST(Roulette, EndsPathsThatLoseNothing) {
    double living = 1, length = 0;
    for (int n = 0; n < longest; ++n) {
        length += living;
        living *= static_cast<double>(best_chance(n));
    }
    EXPECT_LT(length, 260);
    EXPECT_LT(living, 1e-6);
}

TEST(Roulette, KeepsTheVarianceOfBrightRoomsFinite) {
    // The second moment of what a path carries at its n-th surface is albedo^(2 n) over the chance to get there.
    for (const double albedo : {0.98, 0.99, 0.999}) {
        double living = 1, moment = 0, share = 1;
        for (int n = 0; n < longest; ++n) {
            moment += share / living;
            share *= albedo * albedo;
            living *= static_cast<double>(best_chance(n));
        }
        EXPECT_LT(share / living, 1e-9) << albedo;
        // Against paths that go on for ever.
        EXPECT_LT(moment * (1 - albedo * albedo), albedo < 0.995 ? 2 : 40) << albedo;
    }
}

TEST(Roulette, LeavesAViewThroughDarkGlassWithoutNoise) {
    // An absorbing block (index 1) before an even sky, seen straight and in a mirror that takes half.
    test::SceneKit kit;
    kit.root(kit.box({-9, 1, -9}, {9, 2, 9}, kit.material("dark", "dielectric", {{"ior", {1}}, {"absorption", {3}}})));
    kit.root(kit.box({-9, -9, -9}, {9, -8, 9}, kit.material("mirror", "mirror", {{"reflectance", {0.5}}})));
    kit.light("sky", {{"radiance", {1}}});
    const CommittedScene scene = kit.commit();
    const test::PathKit path(scene);
    for (const bool mirrored : {false, true}) {
        const test::Moments found = path.radiance({0, 0, 0}, {0, mirrored ? -1.0 : 1.0, 0}, 40 * test::batch);
        EXPECT_NEAR(found.mean(), (mirrored ? 0.5 : 1) * std::exp(-3), 1e-6);
        EXPECT_NEAR(found.error(), 0, 1e-9);
    }
}

}  // namespace
}  // namespace cardioid

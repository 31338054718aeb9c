/// ARL-TR-3608, note [3]: lamps do not trap their own photons, yet they shadow and reflect those of others.
#include <gtest/gtest.h>

#include "emission_kit.hpp"

namespace cardioid {
namespace {

using photon::Shot;
using test::SceneKit;
using test::shoot;

constexpr std::uint64_t count = 100'000;

SceneKit black_room() {
    SceneKit kit;
    kit.root(test::room(kit, {0, 0, 0}, {1, 1, 1}, kit.material("black", "diffuse", {{"reflectance", {0, 0, 0}}})));
    return kit;
}

/// Every photon that left a lamp with flux lies on a wall.
void expect_all_on_walls(const Shot& shot, std::uint64_t wanted) {
    EXPECT_EQ(shot.photons.size(), wanted);
    for (const photon::Photon& p : shot.photons) {
        const Vec3d at = test::place(shot, p);
        const double inside = std::min({at.x, at.y, at.z, 1 - at.x, 1 - at.y, 1 - at.z});
        ASSERT_LT(std::abs(inside), 1e-6);
    }
    EXPECT_NEAR(shot.ledger.absorbed.g, shot.ledger.emitted.g, 1e-9);
}

TEST(LampFace, OfABallLetsAllItsPhotonsOut) {
    SceneKit kit = black_room();
    kit.light("sphere_light", {{"r", {0.1}}, {"power", {1, 1, 1}}}, Affine::translation({0.5, 0.4, 0.6}));
    expect_all_on_walls(shoot(kit.commit(), count), count);
}

TEST(LampFace, OfAPlateOnTheCeilingLetsAllItsPhotonsOut) {
    for (const double height : {1.0, 0.999}) {
        SceneKit kit = black_room();
        kit.light("area_light", {{"size", {0.4, 0.4}}, {"power", {1, 1, 1}}}, Affine::translation({0.5, 0.5, height}));
        expect_all_on_walls(shoot(kit.commit(), count), count);
    }
}

TEST(LampFace, OfEmissiveSolidsLetsAllTheirPhotonsOut) {
    SceneKit ball = black_room(), box = black_room();
    ball.root(ball.ball({0.5, 0.5, 0.5}, 0.1, ball.material("glow", "emitter", {{"emission", {1, 1, 1}}})));
    box.root(box.box({0.4, 0.4, 0.1}, {0.6, 0.6, 0.3}, box.material("glow", "emitter", {{"emission", {1, 1, 1}}})));
    for (const SceneKit* kit : {&ball, &box}) {
        const Shot shot = shoot(kit->commit(), count);
        // Lines that miss the solid carry no photon; every other arrives.
        expect_all_on_walls(shot, shot.ledger.photons[0]);
        EXPECT_EQ(shot.ledger.rays, shot.photons.size());
        EXPECT_GT(shot.photons.size(), count / 4);
    }
}

TEST(LampFace, InsideAGlassBulbLosesNothing) {
    SceneKit kit = black_room();
    const std::uint32_t glass = kit.material("glass", "dielectric", {{"ior", {1.5}}});
    kit.root(kit.scene.solids.add_node(
        SolidOp::subtract, {kit.ball({0.5, 0.5, 0.5}, 0.2, glass), kit.ball({0.5, 0.5, 0.5}, 0.19, glass)}));
    kit.light("sphere_light", {{"r", {0.02}}, {"power", {1, 1, 1}}}, Affine::translation({0.5, 0.5, 0.5}));
    const Shot shot = shoot(kit.commit(), 30'000);
    // What goes through the bulb is a caustic.
    EXPECT_NEAR(shot.ledger.absorbed.g, 1, 1e-5);
    double on_walls = 0;
    for (const photon::FluxSum& stored : shot.ledger.stored) on_walls += stored.g;
    // A shell met at right angles passes (1 - R) / (1 + R) with R = 0.04; the lamp absorbs what comes back.
    EXPECT_NEAR(on_walls, 0.96 / 1.04, 0.004);
    EXPECT_EQ(shot.ledger.photons[0], 0U);
}

TEST(LampFace, ShadowsTheLightOfOthers) {
    SceneKit kit = black_room();
    kit.light("sphere_light", {{"r", {0.1}}, {"power", {1e-9, 1e-9, 1e-9}}}, Affine::translation({0.5, 0.5, 0.5}));
    kit.light("point_light", {{"power", {1, 1, 1}}}, Affine::translation({0.5, 0.5, 0.9}));
    const Shot shot = shoot(kit.commit(), count);
    // The ball is seen under sin a = 0.1 / 0.4; its shadow on the floor has the radius 0.9 tan a.
    const double shadow = 0.9 * std::tan(std::asin(0.25));
    std::size_t inside = 0, around = 0;
    for (const photon::Photon& p : shot.photons) {
        const Vec3d at = test::place(shot, p) - Vec3d{0.5, 0.5, 0};
        const double r = std::sqrt(at.x * at.x + at.y * at.y);
        if (at.z > 1e-6 || test::flux(shot, p).g < 1e-8F) continue;
        inside += r < shadow * 0.999;
        around += r > shadow * 1.001 && r < shadow * 1.3;
    }
    EXPECT_EQ(inside, 0U);
    EXPECT_GT(around, 300U);
    const double covered = (1 - std::cos(std::asin(0.25))) / 2;
    EXPECT_NEAR(shot.ledger.absorbed.g, 1, 1e-6);
    EXPECT_NEAR(shot.ledger.stored[0].g, 1 - covered, 1e-3);
}

TEST(LampFace, OfAnEmissiveSolidReflectsTheLightOfOthers) {
    SceneKit kit = black_room();
    kit.root(kit.box({0.3, 0.3, 0}, {0.7, 0.7, 0.1},
                     kit.material("glow", "diffuse", {{"reflectance", {0.8, 0.8, 0.8}}, {"emission", {1e-6, 0, 0}}})));
    kit.light("point_light", {{"power", {1, 1, 1}}}, Affine::translation({0.5, 0.5, 0.9}));
    const Shot shot = shoot(kit.commit(), 30'000);
    const photon::Ledger& ledger = shot.ledger;
    EXPECT_GT(ledger.stored[static_cast<std::size_t>(photon::PathClass::indirect)].g, 0.01);
    EXPECT_LT(ledger.gap(), 1e-6);
}

}  // namespace
}  // namespace cardioid

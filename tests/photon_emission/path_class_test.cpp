/// Scenes whose light comes by one of equation 1's ways alone: the other two classes must be empty.
#include "photon/propagation/path_class.hpp"

#include <gtest/gtest.h>

#include "emission_kit.hpp"

namespace cardioid {
namespace {

using photon::PathClass;
using photon::Shot;
using photon::Way;
using test::SceneKit;
using test::shoot;

std::array<std::uint64_t, 3> classes(const SceneKit& kit, const photon::PhotonOptions& options = {},
                                     photon::Keep keep = photon::Keep::everything) {
    return shoot(kit.commit(), 20'000, options, keep).ledger.photons;
}

/// A floor that scatters by `reflectance` under a lamp at z = 4.
SceneKit floor_and_lamp(double reflectance) {
    SceneKit kit;
    const auto material = kit.material("floor", "diffuse", {{"reflectance", {reflectance, reflectance, reflectance}}});
    kit.root(kit.box({-3, -3, -1}, {3, 3, 0}, material));
    kit.light("point_light", {{"power", {1, 1, 1}}}, Affine::translation({0, 0, 4}));
    return kit;
}

TEST(PathClass, IsDirectOnABlackFloor) {
    const auto n = classes(floor_and_lamp(0));
    EXPECT_GT(n[0], 1000U);
    EXPECT_EQ(n[1] + n[2], 0U);
}

// A single convex solid that scatters cannot light itself.
TEST(PathClass, IsDirectOnAConvexDiffuseSolid) {
    const auto n = classes(floor_and_lamp(0.9));
    EXPECT_GT(n[0], 1000U);
    EXPECT_EQ(n[1] + n[2], 0U);
}

TEST(PathClass, IsNeverCausticAmongDiffuseWalls) {
    const auto n = classes(test::lit_room("diffuse", {{"reflectance", {0.5, 0.5, 0.5}}}));
    EXPECT_GT(n[2], 1000U);
    EXPECT_EQ(n[1], 0U);
}

TEST(PathClass, IsCausticBehindGlassOverABlackFloor) {
    SceneKit kit = floor_and_lamp(0);
    kit.root(kit.ball({0, 0, 1.5}, 1, kit.material("glass", "dielectric", {{"ior", {1.5}}})));
    const auto n = classes(kit);
    EXPECT_GT(n[0], 100U);
    EXPECT_GT(n[1], 300U);
    EXPECT_EQ(n[2], 0U);
}

TEST(PathClass, IsCausticAfterAMirrorAndAfterRoughMetal) {
    for (const bool rough : {false, true}) {
        SceneKit kit = floor_and_lamp(0);
        const auto metal = rough ? kit.material("rough", "conductor", {{"roughness", {0.3}}})
                                 : kit.material("mirror", "mirror", {{"reflectance", {1, 1, 1}}});
        kit.root(kit.box({-3, -3.5, 0}, {3, -3, 6}, metal));
        const Shot shot = shoot(kit.commit(), 20'000);
        EXPECT_GT(shot.ledger.photons[1], 300U);
        EXPECT_EQ(shot.ledger.photons[2], 0U);
        std::size_t glossy = 0, specular = 0, on_metal = 0;
        for (const photon::Photon& p : shot.photons) {
            glossy += p.way == Way::glossy;
            specular += p.way == Way::specular;
            on_metal += p.region == 1;
        }
        // Only surfaces with lobes of finite width keep photons.
        EXPECT_EQ(on_metal > 0, rough);
        EXPECT_EQ(glossy > 0, rough);
        EXPECT_EQ(specular > 0, !rough);
    }
}

// World::direct looks through thin filters, so the light behind them is direct and must not be counted again.
TEST(PathClass, IsDirectBehindAFilterWhoseShareItTakes) {
    SceneKit kit = floor_and_lamp(0);
    kit.root(kit.box({-9, -9, 2}, {9, 9, 2.1},
                     kit.material("foil", "filter", {{"reflectance", {0, 0, 0}}, {"transmittance", {0.5, 0.7, 0.9}}})));
    const CommittedScene scene = kit.commit();
    const Shot shot = shoot(scene, 200'000);
    EXPECT_EQ(shot.ledger.photons[1] + shot.ledger.photons[2], 0U);
    Rgb within;
    constexpr double r = 0.5;
    for (const photon::Photon& p : shot.photons) {
        const Vec3d at = test::place(shot, p);
        if (p.region == 0 && at.x * at.x + at.y * at.y < r * r) within += test::flux(shot, p);
    }
    // The disc's solid angle, and two crossings.
    const double share = (1 - 4 / std::sqrt(16 + r * r)) / 2;
    EXPECT_NEAR(within.r, share * 0.25, share * 0.02);
    EXPECT_NEAR(within.b, share * 0.81, share * 0.04);
    const double E = test::irradiance(scene, {0, 0, 0}, {0, 0, 1}, 1);
    EXPECT_NEAR(E, 0.49 / (4 * std::numbers::pi * 16), 1e-5);
}

TEST(PathClass, IsIndirectOnceAnythingDiffuseWasMet) {
    EXPECT_EQ(photon::path_class(Way::direct), PathClass::direct);
    EXPECT_EQ(photon::path_class(Way::specular), PathClass::caustic);
    EXPECT_EQ(photon::path_class(Way::specular | Way::glossy), PathClass::caustic);
    EXPECT_EQ(photon::path_class(Way::diffuse), PathClass::indirect);
    EXPECT_EQ(photon::path_class(Way::diffuse | Way::specular), PathClass::indirect);
    EXPECT_EQ(photon::path_class(Way::glossy | Way::broad), PathClass::indirect);
}

// The caustic pass brings what the global pass has of that class, and nothing else.
TEST(PathClass, OfTheCausticPassIsCausticAlone) {
    SceneKit kit = test::lit_room("diffuse", {{"reflectance", {0.7, 0.7, 0.7}}});
    kit.root(kit.ball({0.5, 0.5, 0.25}, 0.2, kit.material("glass", "dielectric", {{"ior", {1.5}}})));
    const CommittedScene scene = kit.commit();
    const Shot all = shoot(scene, 100'000), own = shoot(scene, 100'000, {}, photon::Keep::caustics, 2);
    EXPECT_EQ(own.ledger.photons[0] + own.ledger.photons[2], 0U);
    EXPECT_EQ(own.photons.size(), own.ledger.photons[1]);
    EXPECT_NEAR(own.ledger.stored[1].g / all.ledger.stored[1].g, 1, 0.03);
    EXPECT_LT(own.ledger.gap(), 1e-6);
}

// Water fills the place up to the glass: light that goes through both ends up below, however the solids nest.
TEST(PathClass, IsCausticThroughNestedMedia) {
    SceneKit kit = floor_and_lamp(0);
    const auto glass = kit.material("glass", "dielectric", {{"ior", {1.5}}, {"priority", {1}}});
    const auto water = kit.material("water", "dielectric", {{"ior", {1.33}}, {"absorption", {0.2, 0.2, 0.2}}});
    kit.root(kit.scene.solids.add_node(SolidOp::subtract, {kit.box({-1, -1, 0.5}, {1, 1, 2}, glass),
                                                           kit.box({-0.9, -0.9, 0.6}, {0.9, 0.9, 3}, glass)}));
    kit.root(kit.box({-0.95, -0.95, 0.55}, {0.95, 0.95, 1.6}, water));
    const Shot shot = shoot(kit.commit(), 50'000);
    EXPECT_GT(shot.ledger.photons[1], 500U);
    EXPECT_EQ(shot.ledger.photons[2], 0U);
    EXPECT_LT(shot.ledger.gap(), 1e-6);
    // Straight down through a metre of water at exp(-0.2) and the glass below, by Fresnel at normal incidence.
    const auto passes = [](double a, double b) { return 4 * a * b / ((a + b) * (a + b)); };
    const double through = passes(1, 1.33) * passes(1.33, 1.5) * passes(1.5, 1) * std::exp(-0.2);
    double within = 0;
    std::size_t n = 0;
    constexpr double r = 0.3;
    for (const photon::Photon& p : shot.photons) {
        const Vec3d at = test::place(shot, p);
        if (p.region != 0 || p.way != Way::specular || at.x * at.x + at.y * at.y > r * r) continue;
        within += double{test::flux(shot, p).g};
        ++n;
    }
    // To first order refraction pulls the cone together as if the lamp were higher by what each layer shortens.
    const double apparent = 4 - 1.0 * (1 - 1 / 1.33) - 0.1 * (1 - 1 / 1.5);
    const double share = (1 - apparent / std::sqrt(apparent * apparent + r * r)) / 2;
    EXPECT_GT(n, 50U);
    EXPECT_NEAR(within / (share * through), 1, 4 / std::sqrt(static_cast<double>(n)) + 0.02);
}

}  // namespace
}  // namespace cardioid

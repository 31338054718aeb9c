#include "photon/propagation/ledger.hpp"

#include <gtest/gtest.h>

#include "emission_kit.hpp"

namespace cardioid {
namespace {

using photon::PathClass;
using test::lit_room;
using test::SceneKit;
using test::shoot;

constexpr auto direct = static_cast<std::size_t>(PathClass::direct);
constexpr auto indirect = static_cast<std::size_t>(PathClass::indirect);

TEST(Ledger, ClosesInEveryKindOfRoom) {
    const SceneKit kits[] = {lit_room("diffuse", {{"reflectance", {0.7, 0.4, 0.1}}}),
                             lit_room("phong", {{"diffuse", {0.3, 0.4, 0.5}}, {"specular", {0.4, 0.4, 0.4}}}),
                             lit_room("plastic", {{"reflectance", {0.9, 0.5, 0.1}}}),
                             lit_room("plastic", {{"reflectance", {0.9, 0.5, 0.1}}, {"roughness", {0.4}}}),
                             lit_room("conductor", {{"roughness", {0.5}}})};
    for (const SceneKit& kit : kits) {
        const photon::Shot shot = shoot(kit.commit(), 20'000);
        EXPECT_LT(shot.ledger.gap(), 1e-6) << kit.scene.materials.back().kind;
        EXPECT_NEAR(shot.ledger.emitted.r, 3, 3e-6);
        EXPECT_NEAR(shot.ledger.emitted.g, 2, 2e-6);
        EXPECT_EQ(shot.ledger.escaped.r, 0);
        EXPECT_EQ(shot.ledger.cut, 0U);
        EXPECT_FLOAT_EQ(shot.power.b, 1);
    }
}

TEST(Ledger, CountsWhatLeavesTheScene) {
    SceneKit kit;
    kit.root(kit.box({-10, -10, -1}, {10, 10, 0}, kit.material("black", "emitter", {})));
    kit.light("point_light", {{"power", {1, 1, 1}}}, Affine::translation({0, 0, 5}));
    const photon::Shot shot = shoot(kit.commit(), 50'000);
    // The solid angle of a 20 x 20 plate from 5 above its middle: 4 asin(a b / ((a^2 + h^2)(b^2 + h^2))^1/2).
    const double plate = 4 * std::asin(100.0 / 125.0) / (4 * std::numbers::pi);
    EXPECT_NEAR(shot.ledger.escaped.r, 1 - plate, 2e-3);
    EXPECT_NEAR(shot.ledger.absorbed.r, plate, 2e-3);
    EXPECT_LT(shot.ledger.gap(), 1e-6);
}

// In a closed room of one albedo every photon meets 1 / (1 - rho) walls on average, a geometric number.
TEST(Ledger, StoresOneOverOneLessAlbedoTimesTheEmittedFlux) {
    constexpr double albedo[] = {0.7, 0.5, 0.2}, power[] = {3, 2, 1};
    constexpr std::uint64_t n = 60'000;
    const photon::Shot shot = shoot(lit_room("diffuse", {{"reflectance", {0.7, 0.5, 0.2}}}).commit(), n);
    const photon::FluxSum& later = shot.ledger.stored[indirect];
    const double stored[] = {later.r, later.g, later.b};
    for (std::size_t c = 0; c < 3; ++c) {
        const double rho = albedo[c], mean = stored[c] / power[c], wanted = rho / (1 - rho);
        // The red channel's photons keep their flux; the number of bounces is geometric with the red albedo.
        const double deviation = std::sqrt(0.7) / 0.3 * wanted / (0.7 / 0.3) * (c == 0 ? 1 : 1.5) / std::sqrt(n);
        EXPECT_GT(test::p_of_z((mean - wanted) / deviation), 1e-4) << c;
        EXPECT_LT(test::p_of_z((mean - wanted * 1.04) / deviation), 1e-2) << c;
    }
    EXPECT_NEAR(shot.ledger.stored[direct].r, 3, 3e-6);
}

TEST(Ledger, OfAWhiteRoomOfMirrorsIsCutOffNotLost) {
    const photon::Shot shot = shoot(lit_room("mirror", {{"reflectance", {1, 1, 1}}}).commit(), 8);
    EXPECT_EQ(shot.ledger.cut, 8U);
    EXPECT_NEAR(shot.ledger.cut_off.r, 3, 1e-5);
    EXPECT_TRUE(shot.photons.empty());
    EXPECT_LT(shot.ledger.gap(), 1e-6);
}

TEST(Ledger, WithoutLightIsEmpty) {
    SceneKit kit;
    kit.root(kit.box({0, 0, 0}, {1, 1, 1}, 0));
    const photon::Shot shot = shoot(kit.commit(), 1000);
    EXPECT_EQ(shot.emitted, 0U);
    EXPECT_TRUE(shot.photons.empty());
    EXPECT_EQ(shot.ledger.gap(), 0);
}

// Photons of a black room are stored once, where they end.
TEST(Ledger, OfOnePhotonInABlackRoomHasOneStored) {
    const photon::Shot shot = shoot(lit_room("diffuse", {{"reflectance", {0, 0, 0}}}).commit(), 1);
    ASSERT_EQ(shot.photons.size(), 1U);
    EXPECT_NEAR(test::flux(shot, shot.photons[0]).r, 3, 0.01);
    EXPECT_EQ(shot.photons[0].way, photon::Way::direct);
}

TEST(Ledger, KeepsOnlyAbsorbedPhotonsWhereAsked) {
    const CommittedScene scene = lit_room("diffuse", {{"reflectance", {0.6, 0.6, 0.6}}}).commit();
    const photon::Shot shot = shoot(scene, 5000, {.store = photon::Store::absorbed});
    EXPECT_EQ(shot.photons.size(), 5000U);
}

}  // namespace
}  // namespace cardioid

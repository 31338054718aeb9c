#include <gtest/gtest.h>
#include <numbers>

#include "emission_kit.hpp"

namespace cardioid {
namespace {

using photon::Shot;
using test::SceneKit;
using test::shoot;

constexpr double pi_d = std::numbers::pi;
constexpr std::uint64_t count = 200'000;

Affine above(double height) { return Affine::translation({0, 0, height}); }

/// A black floor at z = 0 that keeps what falls on it.
SceneKit with_floor() {
    SceneKit kit;
    kit.root(kit.box({-60, -60, -1}, {60, 60, 0}, kit.material("black", "diffuse", {{"reflectance", {0, 0, 0}}})));
    return kit;
}

/// Flux of the photons on the floor within the disc, or the square, of half width a.
double flux_within(const Shot& shot, double a, bool square = false) {
    double sum = 0;
    for (const photon::Photon& p : shot.photons) {
        const Vec3d at = test::place(shot, p);
        const bool inside = square ? std::max(std::abs(at.x), std::abs(at.y)) <= a : at.x * at.x + at.y * at.y <= a * a;
        if (inside && photon::decode_direction(p.n).z > 0.5F) sum += double{test::flux(shot, p).g};
    }
    return sum;
}

/// Photons are equal, so their number within the disc is binomial (and steadier, for they are stratified).
void expect_flux(const Shot& shot, double got, double wanted) {
    const double power = shot.ledger.emitted.g, share = wanted / power;
    // Encoded fluxes are 0.1 % off at worst.
    const double sigma = power * std::sqrt(share * (1 - share) / static_cast<double>(shot.emitted)) + 2e-4 * wanted;
    EXPECT_GT(test::p_of_z((got - wanted) / sigma), 1e-4) << got << " for " << wanted;
    EXPECT_LT(test::p_of_z((got - wanted * 1.03) / sigma), 1e-2);
}

/// Share of a ball's or point's flux that a disc of radius a at distance h gets.
double share_of_disc(double a, double h) { return (1 - h / std::sqrt(h * h + a * a)) / 2; }

TEST(EmittedPhotons, OfAPointLightTheDiscGetsItsSolidAngle) {
    SceneKit kit = with_floor();
    kit.light("point_light", {{"power", {7, 7, 7}}}, above(2));
    const Shot shot = shoot(kit.commit(), count);
    expect_flux(shot, flux_within(shot, 3), 7 * share_of_disc(3, 2));
}

TEST(EmittedPhotons, DrawnFromABallAreAsEven) {
    SceneKit kit = with_floor();
    kit.light("point_light", {{"power", {7, 7, 7}}}, above(2));
    const Shot shot = shoot(kit.commit(), count, {.directions = photon::Directions::ball});
    expect_flux(shot, flux_within(shot, 3), 7 * share_of_disc(3, 2));
}

TEST(EmittedPhotons, OfASpotLightAllFallIntoItsCone) {
    SceneKit kit = with_floor();
    kit.light("spot_light", {{"power", {5, 5, 5}}, {"angle", {30}}}, above(2));
    const Shot shot = shoot(kit.commit(), 20'000);
    EXPECT_NEAR(flux_within(shot, 2 * std::tan(pi_d / 6) + 1e-5), 5, 5e-3);
    // Even intensity: half of the solid angle has half of the flux.
    const double cos_half = 1 - (1 - std::cos(pi_d / 6)) / 2;
    EXPECT_NEAR(flux_within(shot, 2 * std::tan(std::acos(cos_half))), 2.5, 0.02);
}

TEST(EmittedPhotons, OfADiscFollowTheFormFactor) {
    SceneKit kit = with_floor();
    kit.light("disk_light", {{"r", {1}}, {"power", {4, 4, 4}}}, above(2));
    const Shot shot = shoot(kit.commit(), count);
    const double r1 = 0.5, r2 = 2.0 / 2, s = 1 + (1 + r2 * r2) / (r1 * r1);
    const double factor = (s - std::sqrt(s * s - 4 * (r2 / r1) * (r2 / r1))) / 2;
    expect_flux(shot, flux_within(shot, 2), 4 * factor);
}

TEST(EmittedPhotons, OfASquareFollowTheFormFactorOfACube) {
    SceneKit kit = with_floor();
    kit.light("area_light", {{"size", {2, 2}}, {"power", {4, 4, 4}}}, above(2));
    const Shot shot = shoot(kit.commit(), count);
    // Opposite faces of a cube; Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", C-11.
    expect_flux(shot, flux_within(shot, 1, true), 4 * 0.1998249);
}

TEST(EmittedPhotons, OfABallFollowItsFormFactor) {
    for (const bool solid : {false, true}) {
        SceneKit kit = with_floor();
        if (solid)
            kit.root(kit.ball({0, 0, 2}, 0.5, kit.material("glow", "emitter", {{"emission", {1, 1, 1}}})));
        else
            kit.light("sphere_light", {{"r", {0.5}}, {"radiance", {1, 1, 1}}}, above(2));
        const Shot shot = shoot(kit.commit(), solid ? 3 * count : count);
        const double power = pi_d * pi_d;  // pi L 4 pi r^2
        EXPECT_NEAR(shot.power.g, power, power * 0.02);
        // The solid's lines hit its ball one time in three, so that their number has a scatter of its own.
        EXPECT_NEAR(shot.ledger.emitted.g, power, power * (solid ? 0.006 : 1e-5));
        const double wanted = power * share_of_disc(3, 2), sigma = 0.005 * wanted;
        EXPECT_NEAR(flux_within(shot, 3), wanted, 2 * sigma) << solid;
    }
}

TEST(EmittedPhotons, OfAnEmissiveMeshCarryItsPower) {
    SceneKit kit = with_floor();
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {0, 0, 3}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    mesh.closed = true;
    Leaf leaf;
    leaf.kind = LeafKind::mesh;
    leaf.data = kit.scene.solids.add_mesh(mesh);
    leaf.material = kit.material("glow", "emitter", {{"emission", {1, 2, 1}}});
    kit.root(kit.scene.solids.add_leaf(leaf));
    const CommittedScene scene = kit.commit();
    const Shot shot = shoot(scene, count);
    EXPECT_NEAR(shot.ledger.emitted.g, 2 * pi_d * (1.5 + std::sqrt(3.0) / 2), 1e-3);
    // Against the light as World::direct has it, over a square of the floor.
    double wanted = 0;
    constexpr int side = 16;
    for (int i = 0; i < side * side; ++i) {
        const Vec3d p{(i % side + 0.5) / side * 4 - 2, (i / side + 0.5) / side * 4 - 2, 0};
        wanted += test::irradiance(scene, p, {0, 0, 1}, 256) * 16 / (side * side);
    }
    EXPECT_NEAR(flux_within(shot, 2, true), wanted, 0.01 * wanted);
}

TEST(EmittedPhotons, OfTheSunLightTheFloorByTheCosine) {
    for (const double angle : {0.0, 2.0}) {
        SceneKit kit = with_floor();
        kit.light("sun", {{"direction", {0, 1, -1}}, {"irradiance", {3, 3, 3}}, {"angle", {angle}}});
        const Shot shot = shoot(kit.commit(), count);
        expect_flux(shot, flux_within(shot, 50), 3 * std::numbers::sqrt2 / 2 * pi_d * 2500);
    }
}

TEST(EmittedPhotons, OfTheSkyLightTheFloorEvenly) {
    SceneKit kit = with_floor();
    kit.light("sky", {{"radiance", {2, 2, 2}}});
    const Shot shot = shoot(kit.commit(), 2 * count);
    expect_flux(shot, flux_within(shot, 50), 2 * pi_d * pi_d * 2500);
}

TEST(EmittedPhotons, OfTheStudioSkyCarryItsRadiance) {
    SceneKit kit = with_floor();
    LightSettings sky{"sky", test::params_of({}), {}};
    sky.params.set("radiance", std::string("studio"));
    kit.scene.lights.push_back(sky);
    const Shot shot = shoot(kit.commit(), 2 * count);
    // The integral of (0.28 + 0.32 z^2) z over the upper hemisphere.
    const double E = 2 * pi_d * (0.28 / 2 + 0.32 / 4);
    EXPECT_NEAR(flux_within(shot, 50), E * pi_d * 2500, 0.01 * E * pi_d * 2500);
}

// Numbers follow power, to the photon, and all photons carry the same flux.
TEST(EmittedPhotons, AreSharedOutByPower) {
    SceneKit kit = with_floor();
    for (const double power : {1.0, 2.0, 4.0, 8.5})
        kit.light("point_light", {{"power", {power, power, power}}}, above(power));
    const Shot shot = shoot(kit.commit(), 15'501);
    EXPECT_EQ(shot.emitted, 15'501U);
    EXPECT_EQ(shot.ledger.paths, 15'501U);
    EXPECT_NEAR(shot.ledger.emitted.g, 15.5, 1e-4);
    for (const photon::Photon& p : shot.photons) EXPECT_NEAR(test::flux(shot, p).g, 0.001, 4e-6);
}

TEST(EmittedPhotons, AreAsManyForEachLightInTheReportsWay) {
    SceneKit kit = with_floor();
    kit.light("point_light", {{"power", {1, 0, 0}}}, above(1));
    kit.light("point_light", {{"power", {0, 9, 0}}}, above(1));
    const Shot shot = shoot(kit.commit(), 10'000, {.shares = photon::Shares::even});
    std::size_t red = 0;
    for (const photon::Photon& p : shot.photons) red += test::flux(shot, p).r > 0;
    EXPECT_NEAR(static_cast<double>(red) / static_cast<double>(shot.photons.size()), 0.5, 0.01);
    EXPECT_NEAR(shot.ledger.emitted.g, 9, 1e-4);
}

TEST(LargestRemainder, SumsToTheTotalAndKeepsProportions) {
    const double weights[] = {1, 1, 1, 0, 7.3};
    const auto n = photon::largest_remainder(weights, 100);
    EXPECT_EQ(n[0] + n[1] + n[2] + n[3] + n[4], 100U);
    EXPECT_EQ(n[3], 0U);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_LE(std::abs(static_cast<double>(n[i]) - weights[i] / 10.3 * 100), 1);
    const double none[] = {0, 0};
    EXPECT_EQ(photon::largest_remainder(none, 5), (std::vector<std::uint64_t>{0, 0}));
}

}  // namespace
}  // namespace cardioid

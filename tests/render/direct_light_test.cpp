#include <gtest/gtest.h>

#include "scene_kit.hpp"

namespace cardioid {
namespace {

using test::irradiance;
using test::SceneKit;

constexpr double pi_d = std::numbers::pi;
/// How near the closed forms must be met, and how far off shows that the test can fail.
constexpr double tolerance = 0.003, visible_error = 0.02;
constexpr std::uint32_t samples = 4096;

void expect_near(double found, double wanted, const std::string& what) {
    EXPECT_LT(std::abs(found - wanted), tolerance * wanted) << what << ": " << found << " for " << wanted;
    EXPECT_GT(std::abs(found - visible_error * wanted - wanted), tolerance * wanted) << what;
}

/// Turns the front of a lamp, local -z, to where it is wanted; the rows are the images of x, y, z.
Affine placed(Vec3d x, Vec3d y, Vec3d z, Vec3d at) {
    return {{Vec3d{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}, at};
}

TEST(DirectLight, OfASmallLampFallsAsCie171Case52) {
    SceneKit kit;
    constexpr double edge = 0.01;
    const double L = 1000 / (edge * edge);
    kit.light("area_light", {{"size", {edge, edge}}, {"radiance", {L}}}, Affine::translation({2, 2, 3}));
    const CommittedScene scene = kit.commit();
    const std::vector<std::pair<Vec2d, double>> table{
        {{0, 0}, 111.111},  {{0.5, 0}, 105.186},  {{1, 0}, 90},     {{1.5, 0}, 71.111}, {{0.5, 0.5}, 99.723},
        {{1, 0.5}, 85.663}, {{1.5, 0.5}, 68.053}, {{1, 1}, 74.380}, {{1.5, 1}, 59.975}, {{1.5, 1.5}, 49.383}};
    for (const auto& [at, wanted] : table)
        expect_near(irradiance(scene, {2 + at.x, 2 + at.y, 0}, {0, 0, 1}, 64), wanted, "5.2");
}

TEST(DirectLight, OfALampInTheCeilingIsCie171Case53) {
    SceneKit kit;
    kit.light("area_light", {{"size", {1, 1}}, {"radiance", {1000}}}, Affine::translation({2, 2, 3}));
    const CommittedScene scene = kit.commit();
    const double wall[] = {32.677, 75.194, 81.323, 69.061, 53.404, 40.002};
    for (int i = 0; i < 6; ++i)
        expect_near(irradiance(scene, {2, 0, 2.75 - 0.5 * i}, {0, 1, 0}, samples), wall[i], "wall");
    const double floor[] = {61.424, 79.255, 95.667, 105.778, 105.778, 95.667, 79.255, 61.424};
    for (int i = 0; i < 8; ++i)
        expect_near(irradiance(scene, {2, 0.25 + 0.5 * i, 0}, {0, 0, 1}, samples), floor[i], "floor");
}

/// A wall that sends out M = 100 behind a black obstruction of 4 x 0.2 x 1.
TEST(DirectLight, BehindAnObstructionIsCie171Case57) {
    SceneKit kit;
    const std::uint32_t black = kit.material("black", "diffuse", {{"reflectance", {0}}});
    kit.root(kit.box({0, 2.5, 0}, {4, 2.7, 1}, black));
    kit.light("area_light", {{"size", {4, 3}}, {"radiance", {100 / pi_d}}},
              placed({1, 0, 0}, {0, 0, -1}, {0, 1, 0}, {2, 4, 1.5}));
    const CommittedScene scene = kit.commit();
    const double wall[] = {16.071, 16.330, 15.399, 13.322, 10.317, 7.079};
    for (int i = 0; i < 6; ++i)
        expect_near(irradiance(scene, {2, 0, 2.75 - 0.5 * i}, {0, 1, 0}, 4 * samples), wall[i], "wall");
    const double floor[] = {3.382, 3.629, 3.013};
    for (int i = 0; i < 3; ++i)
        expect_near(irradiance(scene, {2, 0.25 + 0.5 * i, 0}, {0, 0, 1}, 16 * samples), floor[i], "floor");
    EXPECT_EQ(irradiance(scene, {2, 1.75, 0}, {0, 0, 1}, samples), 0);
    EXPECT_EQ(irradiance(scene, {2, 2.25, 0}, {0, 0, 1}, samples), 0);
}

TEST(DirectLight, OfADiscOnItsAxisIsTheClosedForm) {
    for (const double h : {0.2, 1.0, 5.0}) {
        SceneKit kit;
        kit.light("disk_light", {{"r", {1}}, {"radiance", {1}}}, Affine::translation({0, 0, h}));
        expect_near(irradiance(kit.commit(), {}, {0, 0, 1}, samples), pi_d / (1 + h * h), "disc");
    }
}

TEST(DirectLight, OfASphereIsTheClosedForm) {
    SceneKit kit;
    kit.light("sphere_light", {{"r", {0.5}}, {"radiance", {2}}}, Affine::translation({1, 0, 2}));
    const double d2 = 5, cosine = 2 / std::sqrt(d2);
    expect_near(irradiance(kit.commit(), {}, {0, 0, 1}, samples), 2 * pi_d * 0.25 / d2 * cosine, "sphere");
}

TEST(DirectLight, OfAFormFactorTableIsMet) {
    // Opposed unit squares: mean over the receiver.
    for (const auto& [d, wanted] : {std::pair{0.5, 0.4152532836}, {1.0, 0.1998248957}, {5.0, 0.0124039773}}) {
        SceneKit kit;
        kit.light("area_light", {{"size", {1, 1}}, {"radiance", {1 / pi_d}}}, Affine::translation({0, 0, d}));
        const CommittedScene scene = kit.commit();
        double sum = 0;
        constexpr int n = 32;
        for (int i = 0; i < n * n; ++i)
            sum += irradiance(scene, {(i % n + 0.5) / n - 0.5, (i / n + 0.5) / n - 0.5, 0}, {0, 0, 1}, 16);
        expect_near(sum / (n * n), wanted, "squares");
    }
}

TEST(DirectLight, OfAnEvenSkyIsPiTimesItsRadiance) {
    SceneKit kit;
    kit.light("sky", {{"radiance", {2}}});
    expect_near(irradiance(kit.commit(), {}, {0, 0, 1}, samples), 2 * pi_d, "sky");
}

TEST(DirectLight, OfManyLampsIsTheSumOfEach) {
    SceneKit kit;
    double wanted = 0;
    for (int i = 0; i < 40; ++i) {
        const Vec3d at{i % 7 - 3.0, i % 5 - 2.0, 3.0};
        const double intensity = 1 + i % 4;
        kit.light("point_light", {{"intensity", {intensity}}}, Affine::translation(at));
        const double d2 = dot(at, at);
        wanted += intensity * at.z / (d2 * std::sqrt(d2));
    }
    expect_near(irradiance(kit.commit(), {}, {0, 0, 1}, samples), wanted, "lamps");
}

TEST(DirectLight, IsTheSameInAWorldAThousandTimesLarger) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        SceneKit kit;
        kit.root(kit.ball(Vec3d{0.3, 0, 1} * scale, 0.3 * scale, 0));
        kit.light("disk_light", {{"r", {scale}}, {"radiance", {1}}}, Affine::translation({0, 0, 2 * scale}));
        static double first = 0;
        const double E = irradiance(kit.commit(), {}, {0, 0, 1}, samples);
        if (first == 0) first = E;
        EXPECT_NEAR(E, first, 1e-5 * first);
    }
}

TEST(DirectLight, ShinesThroughFiltersOnTheWay) {
    SceneKit kit;
    const std::uint32_t foil = kit.material("foil", "filter", {{"reflectance", {0}}, {"transmittance", {0.5}}});
    kit.root(kit.box({-9, -9, 1}, {9, 9, 1.1}, foil));
    kit.light("point_light", {{"intensity", {1}}}, Affine::translation({0, 0, 2}));
    // Two crossings of a half.
    expect_near(irradiance(kit.commit(), {}, {0, 0, 1}, 16), 0.25 / 4, "foil");
}

/// ARL-TR-3608, note [9], with the constants that BRL-CAD has.
TEST(DirectLight, IsAttenuatedAsTheMaterialAsks) {
    const auto reflected = [](bool attenuated, bool point_lamp) {
        SceneKit kit;
        const std::uint32_t phong = kit.material("phong", "phong", {{"diffuse", {0.3}}, {"specular", {0.3}}});
        if (attenuated)
            kit.scene.materials[phong].params.set("attenuation", ParamValue{.numbers = {0.1, 1, 0.01}, .list = true});
        kit.root(kit.box({-9, -9, -1}, {9, 9, 0}, phong));
        const Affine at = Affine::translation({0, 0, 2});
        if (point_lamp)
            kit.light("point_light", {{"intensity", {1}}}, at);
        else
            kit.light("disk_light", {{"r", {0.05}}, {"radiance", {1}}}, at);
        const CommittedScene scene = kit.commit();
        const SurfacePoint point = test::seen(scene, {0.01, 0, 1}, {0, 0, -1});
        BsdfMemory memory;
        const Bsdf* bsdf = scene.bsdf(point, memory);
        double sum = 0;
        for (std::uint32_t i = 0; i < samples; ++i) {
            Sampler sampler(1, Purpose::test, 0, i);
            sum += scene.direct(point, *bsdf, {0, 0, 1}, sampler).r;
        }
        return sum;
    };
    for (const bool point_lamp : {true, false})
        expect_near(reflected(true, point_lamp) / reflected(false, point_lamp), 4 / (0.1 + 2 + 0.04), "phong");
}

TEST(DirectLight, OfAnEmissiveSolidIsThatOfALampOfItsShape) {
    SceneKit kit;
    const std::uint32_t glow = kit.material("glow", "emitter", {{"emission", {2}}});
    kit.root(kit.ball({1, 0, 2}, 0.5, glow));
    const double d2 = 5, cosine = 2 / std::sqrt(d2);
    expect_near(irradiance(kit.commit(), {}, {0, 0, 1}, samples), 2 * pi_d * 0.25 / d2 * cosine, "ball");
}

TEST(DirectLight, OfAnEmissiveBoxWithAHoleIsThatOfItsFaces) {
    SceneKit kit;
    const std::uint32_t glow = kit.material("glow", "diffuse", {{"reflectance", {0.5}}, {"emission", {1}}});
    // A plate of 1 x 1 minus its middle quarter: what a lamp of 1 x 1 gives less one of 0.5 x 0.5. Seen from the axis
    // the walls of the hole face away from nobody: they are made thin.
    const std::uint32_t plate = kit.box({-0.5, -0.5, 1}, {0.5, 0.5, 1.000001}, glow);
    const std::uint32_t hole = kit.box({-0.25, -0.25, 0.5}, {0.25, 0.25, 1.5}, glow);
    kit.root(kit.scene.solids.add_node(SolidOp::subtract, {plate, hole}));
    const auto on_axis = [](double half) {
        const double x = half / std::sqrt(1 + half * half);
        return 4 * x * std::atan(x);
    };
    expect_near(irradiance(kit.commit(), {}, {0, 0, 1}, 16 * samples), (on_axis(0.5) - on_axis(0.25)), "frame");
}

TEST(DirectLight, InAClosedRoomThatGlowsIsEven) {
    SceneKit kit;
    const std::uint32_t glow = kit.material("glow", "diffuse", {{"reflectance", {0.5}}, {"emission", {1}}});
    const std::uint32_t outer = kit.box({-2, -2, -2}, {3, 3, 3}, glow), inner = kit.box({0, 0, 0}, {1, 1, 1}, glow);
    kit.root(kit.scene.solids.add_node(SolidOp::subtract, {outer, inner}));
    const CommittedScene scene = kit.commit();
    for (const Vec3d o : {Vec3d{0.5, 0.5, 0.5}, {0.1, 0.9, 0.3}}) {
        const SurfacePoint floor = test::seen(scene, o, {0, 0, -1});
        const test::WhiteBsdf white;
        double sum = 0;
        for (std::uint32_t i = 0; i < samples; ++i) {
            Sampler sampler(3, Purpose::test, 1, i);
            sum += scene.direct(floor, white, floor.ng, sampler).r;
        }
        expect_near(sum / samples, 1, "room");
    }
}

}  // namespace
}  // namespace cardioid

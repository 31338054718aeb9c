#include <gtest/gtest.h>

#include "path_kit.hpp"

namespace cardioid {
namespace {

using test::expect_mean;
using test::Moments;
using test::PathKit;
using test::SceneKit;

constexpr double pi_d = std::numbers::pi;

/// A material that a test puts into a scene.
struct Recipe {
    const char* kind;
    std::initializer_list<std::pair<const char*, std::vector<double>>> values;
};

/// The unit cube as a room whose walls glow with radiance 1 and reflect rho.
SceneKit furnace(double rho) {
    SceneKit kit;
    const auto glow = kit.material("glow", "diffuse", {{"reflectance", {rho}}, {"emission", {1}}});
    const auto outer = kit.box({-2, -2, -2}, {3, 3, 3}, glow), inner = kit.box({0, 0, 0}, {1, 1, 1}, glow);
    kit.root(kit.scene.solids.add_node(SolidOp::subtract, {outer, inner}));
    return kit;
}

TEST(PathLighting, FillsAFurnaceWithEmissionOverAbsorption) {
    for (const double rho : {0.5, 0.8, 0.9}) {
        const SceneKit kit = furnace(rho);
        const CommittedScene scene = kit.commit();
        expect_mean(PathKit(scene).radiance({0.3, 0.4, 0.6}, {1, 0.2, -0.3}, 60 * test::batch), 1 / (1 - rho),
                    "furnace");
    }
}

TEST(PathLighting, FillsAFurnaceEvenlyAroundLosslessGlass) {
    for (const Recipe& r : {Recipe{"dielectric", {}}, {"mirror", {}}, {"filter", {{"reflectance", {1}}}}}) {
        SceneKit kit = furnace(0.5);
        kit.root(kit.ball({0.5, 0.5, 0.5}, 0.3, kit.material("ball", r.kind, r.values)));
        const CommittedScene scene = kit.commit();
        expect_mean(PathKit(scene).radiance({0.5, 0.1, 0.6}, {0.1, 1, -0.2}, 60 * test::batch), 2, r.kind);
    }
}

TEST(PathLighting, ShowsUnderAnEvenSkyTheAlbedoOfEveryMaterial) {
    const Recipe recipes[] = {
        {"diffuse", {{"reflectance", {0.7}}}},
        {"phong", {{"diffuse", {0.4}}, {"specular", {0.5}}, {"exponent", {40}}}},
        {"plastic", {{"reflectance", {0.6}}}},
        {"conductor", {{"roughness", {0.4}}}},
        {"conductor", {}},
        {"mirror", {{"reflectance", {0.8}}}},
    };
    for (const Recipe& r : recipes)
        for (const bool lamp : {false, true}) {
            SceneKit kit;
            kit.root(kit.ball({0, 0, 0}, 1, kit.material("ball", r.kind, r.values)));
            kit.light("sky", {{"radiance", {1}}});
            // A second light, dark, so that one is chosen among several.
            if (lamp) kit.light("sphere_light", {{"r", {1}}, {"radiance", {1}}}, Affine::translation({9, 0, 0}));
            const CommittedScene scene = kit.commit();
            const Vec3d o{-5, 0.4, 0.5}, d{1, 0, 0};
            const SurfacePoint point = test::seen(scene, o, d);
            BsdfMemory memory;
            const double albedo =
                static_cast<double>(scene.bsdf(point, memory)->albedo(point.frame.to_local({-1, 0, 0})).total().g);
            const Moments found = PathKit(scene).radiance(o, d, 60 * test::batch);
            // The albedo of rough surfaces comes from a table; the lamp is out of sight and covers sky nowhere.
            expect_mean(found, albedo, r.kind, 0.0015 * albedo);
        }
}

TEST(PathLighting, MeetsTheReferenceCube) {
    // Unit cube, the ceiling emits M = 1, all faces reflect rho: irradiance at the floor's centre by quadrature.
    for (const auto& [rho, wanted] : {std::pair{0.5, 0.395209}, {0.8, 0.891352}}) {
        SceneKit kit;
        const auto wall = kit.material("wall", "diffuse", {{"reflectance", {rho}}});
        const auto glow = kit.material("glow", "diffuse", {{"reflectance", {rho}}, {"emission", {1 / pi_d}}});
        const auto outer = kit.box({-1, -1, -1}, {2, 2, 1}, wall), inner = kit.box({0, 0, 0}, {1, 1, 2}, wall);
        kit.root(kit.scene.solids.add_node(SolidOp::subtract, {outer, inner}));
        kit.root(kit.box({-1, -1, 1}, {2, 2, 2}, glow));
        const CommittedScene scene = kit.commit();
        expect_mean(PathKit(scene).radiance({0.5, 0.5, 0.9}, {0, 0, -1}, 400 * test::batch), wanted * rho / pi_d,
                    "cube", 1e-4);
    }
}

TEST(PathLighting, CountsBouncesForItsDepth) {
    constexpr double rho = 0.8;
    const SceneKit kit = furnace(rho);
    const CommittedScene scene = kit.commit();
    double wanted = 0;
    for (int depth = 0; depth <= 4; ++depth) {
        wanted += std::pow(rho, depth);
        const PathKit path(scene, {{"depth", depth}});
        expect_mean(path.radiance({0.3, 0.4, 0.6}, {1, 0.2, -0.3}, 60 * test::batch), wanted, "depth");
    }
}

TEST(PathLighting, RefusesADepthThatIsNoCount) {
    for (const double depth : {-1.0, 0.5, 1e300}) {
        Params params("--set");
        params.set("depth", depth);
        EXPECT_THROW(static_cast<void>(path_lighting.make(params, 0)), Error) << depth;
    }
}

TEST(PathLighting, AbsorbsBetweenALampAndAPointWithinAMedium) {
    SceneKit kit;
    const auto fog = kit.material("fog", "dielectric", {{"ior", {1.3}}, {"absorption", {0.5}}});
    kit.root(kit.box({-9, -9, -9}, {9, 9, 9}, fog));
    kit.root(kit.box({-1, -1, -1}, {1, 1, 0}, 0));
    kit.light("point_light", {{"intensity", {1}}}, Affine::translation({0, 0, 2}));
    const CommittedScene scene = kit.commit();
    const PathKit path(scene, {{"depth", 1}});
    // From the eye at height 1: the lamp at 2 sends its light down 2, and it comes up 1.
    const double wanted = 0.5 / pi_d / 4 * std::exp(-0.5 * 3);
    expect_mean(path.radiance({0, 0, 1}, {0, 0, -1}, 40 * test::batch), wanted, "fog");
}

TEST(PathLighting, IsBlackWithoutLightAndSeesNothingWhereNothingIs) {
    SceneKit kit;
    kit.root(kit.box({-1, -1, -1}, {1, 1, 0}, 0));
    const CommittedScene scene = kit.commit();
    EXPECT_EQ(PathKit(scene).radiance({0, 0, 1}, {0, 0, -1}, 40 * test::batch).mean(), 0);
    EXPECT_EQ(PathKit(scene).radiance({0, 0, 1}, {0, 0, 1}, 40 * test::batch).mean(), 0);
    const CommittedScene empty = SceneKit().commit();
    EXPECT_EQ(PathKit(empty).radiance({0, 0, 1}, {0, 0, 1}, 40 * test::batch).mean(), 0);
}

TEST(PathLighting, SeesALampFromWithinGlassWithRadianceSquaredByTheIndex) {
    SceneKit kit;
    kit.root(kit.box({-9, -9, -9}, {9, 9, 9}, kit.material("glass", "dielectric", {{"ior", {1.5}}})));
    kit.light("sky", {{"radiance", {1}}});
    const CommittedScene scene = kit.commit();
    // Every ray that leaves the block sees the sky, so that all light within it has n^2 times its radiance.
    expect_mean(PathKit(scene).radiance({0, 0, 0}, {0.1, 0.2, 1}, 40 * test::batch), 2.25, "glass");
}

TEST(PathLighting, AttenuatesLampsAsTheMaterialAsks) {
    const auto reflected = [](bool attenuated, bool lamp) {
        SceneKit kit;
        const auto phong = kit.material("phong", "phong", {{"diffuse", {0.3}}, {"specular", {0.3}}});
        if (attenuated)
            kit.scene.materials[phong].params.set("attenuation", ParamValue{.numbers = {0.1, 1, 0.01}, .list = true});
        kit.root(kit.box({-9, -9, -1}, {9, 9, 0}, phong));
        const Affine at = Affine::translation({0, 0, 2});
        if (lamp)
            kit.light("disk_light", {{"r", {0.05}}, {"radiance", {1}}}, at);
        else
            kit.light("point_light", {{"intensity", {1}}}, at);
        const CommittedScene scene = kit.commit();
        return PathKit(scene).radiance({0.01, 0, 1}, {0, 0, -1}, 40 * test::batch);
    };
    for (const bool lamp : {false, true})
        expect_mean(reflected(true, lamp), 4 / (0.1 + 2 + 0.04) * reflected(false, lamp).mean(), "phong",
                    0.002 * reflected(true, lamp).mean());
}

}  // namespace
}  // namespace cardioid

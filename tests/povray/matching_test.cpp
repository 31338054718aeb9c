/// What is there for comparing alone: --lighting whitted, grid, straight_shadows, pov_finish; against figures by hand.
#include <gtest/gtest.h>

#include "cli/commands/lighting_choice.hpp"
#include "rt_core/render/lighting/whitted_lighting.hpp"
#include "tests/povray/twin.hpp"
#include "tests/render/scene_kit.hpp"
#include "tests/shaders/make.hpp"

namespace cardioid::test {
namespace {

/// What comes to o along d, by one sample of that number.
Rgb radiance(const SceneKit& kit, Vec3d o, Vec3d d, std::uint32_t sample = 0) {
    const CommittedScene scene = kit.commit();
    const std::unique_ptr<LightingModule> lighting = whitted_lighting.make({}, 0);
    Progress silence;
    lighting->prepare(scene, nullptr, silence);
    Sampler sampler(0, Purpose::test, 0, sample);
    const EyeRay eye{{o, normalize(d), Box3d::infinity, {}, {}}, scene.medium_at(o)};
    return lighting->incoming(scene, eye, sampler)->sum();
}

/// A clear ball under an even sky shows the sky in every direction, whichever ways the light takes.
TEST(Whitted, SeesAnEvenSkyThroughAClearBall) {
    SceneKit kit;
    kit.root(kit.ball({0, 0, 0}, 1, kit.material("glass", "dielectric", {{"ior", {1.5}}})));
    kit.light("sky", {{"radiance", {2.0}}});
    for (const double aside : {0.0, 0.3, 0.6, 0.9, 0.99})
        EXPECT_NEAR(radiance(kit, {aside, 0.05, -5}, {0, 0, 1}).g, 2, 1e-4) << aside;
}

/// A pane of n = 1.5 seen straight reflects 2 R/(1 + R), R = 0.04, when all that goes to and fro in it is counted.
TEST(Whitted, CountsAllThatGoesToAndFroInAPane) {
    SceneKit kit;
    kit.root(kit.box({-9, -9, 0}, {9, 9, 1}, kit.material("glass", "dielectric", {{"ior", {1.5}}})));
    kit.root(kit.box({-9, -9, 5}, {9, 9, 6}, kit.material("lamp", "emitter", {{"emission", {1.0}}})));
    EXPECT_NEAR(radiance(kit, {0.1, 0.2, -5}, {0, 0, 1}).g, 1 - 2 * 0.04 / 1.04, 1e-5);
}

TEST(Whitted, HasNoNoise) {
    SceneKit kit;
    kit.root(kit.ball({0, 0, 0}, 1, kit.material("glass", "dielectric", {{"ior", {1.5}}})));
    kit.root(kit.box({-9, -9, -3}, {9, 9, -2}, 0));
    kit.light("area_light", {{"size", {1, 1}}, {"radiance", {5.0}}, {"grid", {4}}}, Affine::translation({0, 0, 4}));
    const Vec3d o{0.4, -5, 1}, d{0, 5, -1.3};
    const Rgb first = radiance(kit, o, d, 0);
    EXPECT_GT(first.g, 0);
    for (std::uint32_t sample = 1; sample < 5; ++sample) EXPECT_EQ(radiance(kit, o, d, sample), first);
}

/// Sum over 3 x 3 points of L A/9 cos cos / d^2, times the reflectance over pi.
TEST(Grid, IsTheSumOverItsPoints) {
    SceneKit kit;
    kit.root(kit.box({-9, -9, -1}, {9, 9, 0}, 0));
    kit.light("area_light", {{"size", {2, 4}}, {"radiance", {3.0}}, {"grid", {3}}}, Affine::translation({1, 0, 2}));
    double E = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double x = 1 + 2 * ((i + 0.5) / 3 - 0.5) - 0.3, y = 4 * ((j + 0.5) / 3 - 0.5) + 0.4;
            const double d2 = x * x + y * y + 4;
            E += 3.0 * 8 / 9 * (2 * 2 / d2) / d2;
        }
    EXPECT_NEAR(radiance(kit, {0.3, -0.4, 1}, {0, 0, -1}).g, 0.5 * E / std::numbers::pi, 1e-5 * E);
}

/// Each of the points has its own visibility: a plate hides those at x = 0.5 and leaves those at x = -0.5.
TEST(Grid, IsDarkWhereAPointIsHidden) {
    SceneKit kit;
    kit.root(kit.box({-9, -9, -1}, {9, 9, 0}, 0));
    kit.root(kit.box({0, -9, 1}, {9, 9, 1.1}, 0));
    kit.light("area_light", {{"size", {2, 2}}, {"radiance", {3.0}}, {"grid", {2}}}, Affine::translation({0, 0, 2}));
    double E = 0;
    for (const double y : {-0.5, 0.5}) {
        const double d2 = 0.49 * 0.49 + (y - 0.2) * (y - 0.2) + 4;
        E += 3.0 * 4 / 4 * (2 * 2 / d2) / d2;
    }
    EXPECT_NEAR(radiance(kit, {-0.01, 0.2, 0.5}, {0, 0, -1}).g, 0.5 * E / std::numbers::pi, 1e-5 * E);
}

/// Two units of glass that takes 0.3 a unit, under a lamp straight above.
TEST(StraightShadows, TakeWhatTheGlassAbsorbs) {
    const auto under = [](double absorption, double straight) {
        SceneKit kit;
        kit.root(kit.box({-9, -9, -1}, {9, 9, 0}, 0));
        kit.root(
            kit.box({-2, -2, 1}, {2, 2, 3},
                    kit.material("glass", "dielectric",
                                 {{"ior", {1.5}}, {"absorption", {absorption}}, {"straight_shadows", {straight}}})));
        kit.light("point_light", {{"intensity", {10.0}}}, Affine::translation({0, 0, 8}));
        return radiance(kit, {0, 0, 0.5}, {0, 0, -1}).g;
    };
    EXPECT_EQ(under(0.3, 0), 0);
    EXPECT_NEAR(under(0, 1), 0.5 / std::numbers::pi * 10 / 64, 1e-6);
    EXPECT_NEAR(under(0.3, 1) / under(0, 1), std::exp(-0.6), 1e-5);
}

/// Photons bring bent light to where straight shadows would let it through as well.
TEST(StraightShadows, EndWhereBentLightIsFollowed) {
    for (const LightingKind& kind : registry().lighting()) {
        Scene scene;
        scene.materials.push_back({"glass", "dielectric", Params("a.csg:1")});
        scene.materials[0].params.set("straight_shadows",
                                      ParamValue{.kind = ParamValue::Kind::boolean, .boolean = true});
        cli::LightingChoice choice{.kind = &kind};
        cli::end_straight_shadows(scene, choice);
        const std::string_view name = kind.name;
        const bool follows = name == "photon" || name == "path";
        EXPECT_EQ(scene.materials[0].params.boolean("straight_shadows", false), !follows) << name;
        EXPECT_EQ(choice.warnings.size(), follows ? 1U : 0U) << name;
    }
}

SurfacePoint facing_up() {
    SurfacePoint hit;
    hit.ng = {0, 0, 1};
    hit.frame = Frame(hit.ng);
    return hit;
}

/// phong cos^n alpha and specular (n.h)^(1/r), over pi, without the cosine towards the light.
TEST(PovFinish, HasTheHighlightsOfPovRay) {
    const Vec3 wo = normalize(Vec3{0.3F, 0, 1}), wi = normalize(Vec3{-0.5F, 0.1F, 0.8F});
    const auto scattered = [&](const Values& values) {
        BsdfMemory memory;
        const auto shader = make_shader("pov_finish", values);
        return shader->bsdf(facing_up(), memory)->f(wo, wi).g * wi.z * std::numbers::pi;
    };
    const double alpha = double{dot(wi, Vec3{-wo.x, -wo.y, wo.z})}, half = double{normalize(wo + wi).z};
    const Values none{{"pigment", number(0)}};
    const auto with = [&](const std::string& name, double x, const std::string& more, double y) {
        Values values = none;
        values[name] = number(x), values[more] = number(y);
        return values;
    };
    EXPECT_NEAR(scattered(with("phong", 0.7, "phong_size", 12)), 0.7 * std::pow(alpha, 12), 1e-6);
    EXPECT_NEAR(scattered(with("specular", 0.4, "roughness", 0.1)), 0.4 * std::pow(half, 10), 1e-6);
    EXPECT_NEAR(scattered({{"pigment", number(0.6)}, {"diffuse", number(0.5)}, {"brilliance", number(2)}}),
                0.3 * std::pow(double{wi.z}, 2), 1e-6);
}

/// From the front a metal's highlight has the pigment's colour: F is 0.014567225/1.12^2 - 0.011612903 = 0 there.
TEST(PovFinish, TintsTheHighlightOfMetal) {
    BsdfMemory memory;
    const auto shader = make_shader("pov_finish", {{"pigment", list({0.8, 0.5, 0.1})},
                                                   {"diffuse", number(0)},
                                                   {"phong", number(1)},
                                                   {"phong_size", number(1)},
                                                   {"metallic", number(1)}});
    const Rgb f = shader->bsdf(facing_up(), memory)->f({0, 0, 1}, {0, 0, 1}) * pi;
    EXPECT_NEAR(f.r, 0.8, 1e-4);
    EXPECT_NEAR(f.g, 0.5, 1e-4);
    EXPECT_NEAR(f.b, 0.1, 1e-4);
}

}  // namespace
}  // namespace cardioid::test

#include "rt_core/render/commit/emissive_solid.hpp"

#include <gtest/gtest.h>

#include "scene_kit.hpp"

namespace cardioid {
namespace {

using test::SceneKit;

constexpr double pi_d = std::numbers::pi;

SceneKit glowing_ball(double r) {
    SceneKit kit;
    kit.root(kit.ball({1, 2, 3}, r, kit.material("glow", "emitter", {{"emission", {1, 2, 0}}})));
    return kit;
}

SceneKit glowing_box() {
    SceneKit kit;
    kit.root(kit.box({0, 0, 0}, {1, 2, 0.1}, kit.material("glow", "emitter", {{"emission", {1, 1, 1}}})));
    return kit;
}

/// A closed mesh of the unit cube's lower corner: one emissive tetrahedron.
SceneKit glowing_mesh() {
    SceneKit kit;
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    mesh.closed = true;
    Leaf leaf;
    leaf.kind = LeafKind::mesh;
    leaf.data = kit.scene.solids.add_mesh(mesh);
    leaf.material = kit.material("glow", "emitter", {{"emission", {1, 1, 1}}});
    kit.root(kit.scene.solids.add_leaf(leaf));
    return kit;
}
constexpr double tetrahedron_area = 1.5 + 0.8660254037844386;

/// Mean flux of many photons, and how many came with any.
double emitted_flux(const Light& light, const CommittedScene& scene, double& outward) {
    double sum = 0;
    int lit = 0, leaving = 0;
    constexpr std::uint32_t n = 40'000;
    for (std::uint32_t i = 0; i < n; ++i) {
        Sampler sampler(5, Purpose::photons, i, 0);
        const Vec2 place = sampler.next2();
        const LightEmission photon = light.emit(place, sampler.next2());
        if (is_black(photon.flux)) continue;
        sum += photon.flux.r;
        ++lit;
        // Convex solids: nothing of their own stands in the way.
        leaving += dot(Vec3(photon.ray.d), photon.ray.from_ng) > 0 && !scene.intersect(photon.ray).found();
    }
    outward = static_cast<double>(leaving) / lit;
    return sum / n;
}

/// Area that the power of the only light of radiance 1 stands for.
double lit_area(const SceneKit& kit) { return kit.commit().lights().back()->power().r / pi_d; }

TEST(EmissiveSolid, OfOneSimpleShapeKnowsItsPowerExactly) {
    const CommittedScene ball = glowing_ball(0.5).commit();
    const Rgb power = ball.lights().back()->power();
    const double wanted = pi_d * 4 * pi_d * 0.25;
    EXPECT_NEAR(power.r, wanted, 1e-6 * wanted);
    EXPECT_NEAR(power.g, 2 * wanted, 2e-6 * wanted);
    EXPECT_EQ(power.b, 0);
    EXPECT_NEAR(lit_area(glowing_box()), 2 * 2 + 0.2 * 3, 1e-5);
    EXPECT_NEAR(lit_area(glowing_mesh()), tetrahedron_area, 1e-5);
    SceneKit round;
    const std::uint32_t glow = round.material("glow", "emitter", {{"emission", {1, 1, 1}}});
    const auto leaf = [&](LeafKind kind, Vec3d scale, double a, double b) {
        round.scene.solids = {};
        Leaf made;
        made.kind = kind;
        made.to_world = Affine{{Vec3d{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, {3, 4, 5}} * Affine::scaling(scale);
        made.a = a, made.b = b, made.material = glow;
        round.root(round.scene.solids.add_leaf(made));
        return lit_area(round);
    };
    EXPECT_NEAR(leaf(LeafKind::cone, {2, 2, 3}, 1, 0.5), pi_d * (4 + 1 + 3 * std::hypot(3, 1)), 1e-4);
    EXPECT_NEAR(leaf(LeafKind::torus, {2, 2, 2}, 1, 0.25), 4 * pi_d * pi_d * 0.25 * 4, 1e-4);
}

TEST(EmissiveSolid, OfAnyShapeKnowsItsPowerToAThousandth) {
    SceneKit kit;
    const std::uint32_t glow = kit.material("glow", "emitter", {{"emission", {1, 1, 1}}});
    const auto area = [&](std::uint32_t root) {
        kit.scene.solids.roots = {root};
        return lit_area(kit);
    };
    const auto subtract = [&](std::uint32_t a, std::uint32_t b) {
        return kit.scene.solids.add_node(SolidOp::subtract, {a, b});
    };
    const auto near = [](double found, double wanted) { EXPECT_NEAR(found, wanted, 0.0015 * wanted); };
    const double e = std::sqrt(0.75);  // eccentricity of a spheroid of half axes 1, 1, 2
    near(area(kit.leaf(LeafKind::sphere, Affine::scaling({1, 1, 2}), glow)), 2 * pi_d * (1 + 2 / e * std::asin(e)));
    near(area(subtract(kit.box({0, 0, 0}, {1, 1, 1}, glow), kit.box({0.25, 0.25, -1}, {0.75, 0.75, 2}, glow))), 7.5);
    near(area(subtract(kit.ball({}, 1, glow), kit.ball({0, 0, 1}, 1, glow))), 4 * pi_d);
    near(area(subtract(kit.box({-2, -2, -2}, {2, 2, 2}, glow), kit.ball({}, 1, glow))), 96 + 4 * pi_d);
}

TEST(EmissiveSolid, EmitsItsPowerInPhotonsThatLeaveIt) {
    double outward = 0;
    const CommittedScene ball = glowing_ball(0.5).commit();
    EXPECT_NEAR(emitted_flux(*ball.lights().back(), ball, outward), pi_d * pi_d, 0.02 * pi_d * pi_d);
    EXPECT_EQ(outward, 1);
    const CommittedScene box = glowing_box().commit();
    const double wanted = pi_d * 4.6;
    EXPECT_NEAR(emitted_flux(*box.lights().back(), box, outward), wanted, 0.02 * wanted);
    EXPECT_EQ(outward, 1);
    const CommittedScene mesh = glowing_mesh().commit();
    EXPECT_NEAR(emitted_flux(*mesh.lights().back(), mesh, outward), pi_d * tetrahedron_area, 0.02 * pi_d * 2.37);
    EXPECT_GT(outward, 0.9999);
}

TEST(EmissiveSolid, WithoutEndEmitsWhatItTellsToo) {
    // A glowing ground under a small ball: both are taken within the scene's sphere.
    SceneKit kit;
    kit.root(kit.ball({0, 0, 1}, 0.5, 0));
    kit.root(kit.leaf(LeafKind::half_space, Affine::translation({0, 0, 0.75}),
                      kit.material("glow", "emitter", {{"emission", {1, 1, 1}}})));
    const CommittedScene scene = kit.commit();
    double outward = 0;
    const double power = scene.lights().back()->power().r;
    EXPECT_GT(power, 0);
    EXPECT_NEAR(emitted_flux(*scene.lights().back(), scene, outward), power, 0.02 * power);
}

TEST(EmissiveSolid, SamplesDirectionsWithTheDensityItTells) {
    const CommittedScene scene = glowing_ball(0.5).commit();
    const Light& light = *scene.lights().back();
    for (const Vec3d p : {Vec3d{1, 2, 9}, {-40, 7, 3}, {1.1, 2.2, 3}}) {
        double cone = 0;
        for (std::uint32_t i = 0; i < 1000; ++i) {
            Sampler sampler(1, Purpose::test, 0, i);
            const LightSample s = light.sample(p, sampler.next2());
            EXPECT_TRUE(s.trace);
            EXPECT_NEAR(light.pdf(p, s.wi), s.pdf, 1e-4F * s.pdf);
            cone = 1 / s.pdf;
        }
        // Uniform over the cone: the share of all directions that has a density is the cone's.
        int inside = 0;
        constexpr int n = 100'000;
        for (std::uint32_t i = 0; i < n; ++i) {
            Sampler sampler(2, Purpose::test, 0, i);
            inside += light.pdf(p, sample_sphere(sampler.next2())) > 0;
        }
        EXPECT_NEAR(inside / static_cast<double>(n), cone / (4 * pi_d), 5e-4 + 0.02 * cone / (4 * pi_d));
    }
}

TEST(EmissiveSolid, OfAMeshLightsAsItsRegionDoes) {
    // The same tetrahedron as a mesh alone, and as a mesh within a boolean.
    SceneKit kit = glowing_mesh();
    const double alone = test::irradiance(kit.commit(), {0.2, 0.2, -2}, {0, 0, 1}, 16'384);
    // Facing face: seen from below, the right triangle z = 0.
    SceneKit boolean = glowing_mesh();
    const std::uint32_t mesh = boolean.scene.solids.roots[0];
    boolean.scene.solids.roots[0] = boolean.scene.solids.add_node(
        SolidOp::intersect, {mesh, boolean.box({-1, -1, -1}, {2, 2, 2}, boolean.scene.solids.leaves[0].material)});
    EXPECT_NEAR(test::irradiance(boolean.commit(), {0.2, 0.2, -2}, {0, 0, 1}, 16'384), alone, 0.005 * alone);
}

}  // namespace
}  // namespace cardioid

#include "rt_core/render/measure/plate.hpp"

#include <gtest/gtest.h>

#include "scene_kit.hpp"

#include "rt_core/render/lighting/direct_lighting.hpp"
#include "rt_core/render/probe.hpp"

namespace cardioid {
namespace {

using test::SceneKit;

constexpr double pi_d = std::numbers::pi;

Reading measured(const CommittedScene& scene, Vec3d p, Vec3d d) {
    const std::unique_ptr<LightingModule> module = direct_lighting.make({}, 0);
    Progress silent;
    const ProbePoint point{p, d};
    return probe(scene, *module, {&point, 1}, {.noise = 2e-3, .most_samples = 1 << 15}, silent)[0];
}

/// A box from (0, 0, 0) to (2, 2, 2) times s under an even sky of radiance 1.
SceneKit box_under_sky(double s) {
    SceneKit kit;
    kit.root(kit.box({0, 0, 0}, {2 * s, 2 * s, 2 * s}, 0));
    kit.light("sky", {{"radiance", {1, 1, 1}}});
    return kit;
}

TEST(Plate, OnFacesEdgesAndCornersSeesTheWholeSkyAtAnyScale) {
    for (const double s : {1e4, 1e-4}) {
        const CommittedScene scene = box_under_sky(s).commit();
        for (const double x : {0.0, 0.7, 2.0})
            for (const double y : {0.0, 2.0}) {
                EXPECT_NEAR(measured(scene, Vec3d{x, y, 2} * s, {0, 0, 1}).value.g, pi_d, 0.03) << x << ' ' << y;
                EXPECT_NEAR(measured(scene, Vec3d{x, 0, y} * s, {0, -1, 0}).value.g, pi_d, 0.03) << x << ' ' << y;
            }
    }
}

TEST(Plate, WrittenWithSixDigitsIsOnTheSurfaceStill) {
    const CommittedScene scene = box_under_sky(1).commit();
    for (const double off : {-9e-6, -1e-9, 1e-9, 9e-6}) {
        const Reading r = measured(scene, {1, 1, 2 + off}, {0, 0, 1});
        EXPECT_NEAR(r.value.g, pi_d, 0.03) << off;
        EXPECT_FALSE(r.buried);
    }
    EXPECT_TRUE(measured(scene, {1, 1, 2 - 1e-3}, {0, 0, 1}).buried);
}

TEST(Plate, InFreeSpaceSeesWhatOneOnTheSurfaceSees) {
    const CommittedScene scene = box_under_sky(1).commit();
    const double on = measured(scene, {1, 0, 1}, {0, -1, 0}).value.g;
    EXPECT_NEAR(measured(scene, {1, -0.001, 1}, {0, -1, 0}).value.g, on, 0.01 * on);
    // A level plate at the foot of a wall that is half as high as it is far gets what is not behind the wall.
    EXPECT_NEAR(measured(scene, {1, -1e-3, 1}, {0, 0, 1}).value.g, pi_d / 2, 0.02);
    // One that looks at the wall from very near sees nothing but the wall.
    EXPECT_NEAR(measured(scene, {1, -1e-3, 1}, {0, 1, 0}).value.g, 0, 0.01);
}

TEST(Plate, TiltedOnASurfaceSeesOnlyWhatIsAboveIt) {
    const CommittedScene scene = box_under_sky(1).commit();
    // (1 + cos)/2 of the sky is above both horizons.
    for (const double angle : {0.2, 0.9, 1.2, 1.5707, 1.7, 2.5}) {
        const Reading r = measured(scene, {1, 1, 2}, {std::sin(angle), 0, std::cos(angle)});
        EXPECT_NEAR(r.value.g, pi_d * (1 + std::cos(angle)) / 2, 0.03) << angle;
        EXPECT_FALSE(r.buried);
    }
}

TEST(Plate, InAnInnerEdgeOrCornerSeesItsShareOfTheSky) {
    SceneKit kit;
    kit.root(kit.box({-9, -9, -1}, {9, 9, 0}, 0));
    kit.root(kit.box({-1, -9, 0}, {0, 9, 1e4}, 0));
    kit.light("sky", {{"radiance", {1, 1, 1}}});
    EXPECT_NEAR(measured(kit.commit(), {0, 0, 0}, {0, 0, 1}).value.g, pi_d / 2, 0.02);
    kit.root(kit.box({-9, -1, 0}, {9, 0, 1e4}, 0));
    EXPECT_NEAR(measured(kit.commit(), {0, 0, 0}, {0, 0, 1}).value.g, pi_d / 4, 0.01);
    EXPECT_NEAR(measured(kit.commit(), {0, 0, 0}, {1, 1, 1}).value.g, std::sqrt(3.0) * pi_d / 4, 0.02);
}

TEST(Plate, OnAThinWallIsOnTheSideItLooksTo) {
    for (const double thickness : {0.1, 1e-3, 1e-6, 1e-9}) {
        SceneKit kit;
        kit.root(kit.box({-5, -5, -5}, {5, 5, 5 + thickness}, 0));
        kit.scene.solids.roots.clear();
        kit.root(kit.box({-5, -5, 1}, {5, 5, 1 + thickness}, 0));
        kit.light("point_light", {{"intensity", {4}}}, Affine::translation({0, 0, 3}));
        const CommittedScene scene = kit.commit();
        const double lit = 4 / std::pow(2 - thickness, 2);
        EXPECT_NEAR(measured(scene, {0, 0, 1 + thickness}, {0, 0, 1}).value.g, lit, 1e-5) << thickness;
        EXPECT_EQ(measured(scene, {0, 0, 1}, {0, 0, -1}).value.g, 0) << thickness;
        EXPECT_FALSE(measured(scene, {0, 0, 1}, {0, 0, -1}).buried) << thickness;
    }
}

/// An open square of two triangles in the plane z = 0, its front up.
SceneKit open_sheet() {
    SceneKit kit;
    TriangleMesh mesh;
    mesh.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    Leaf leaf;
    leaf.kind = LeafKind::mesh;
    leaf.data = kit.scene.solids.add_mesh(mesh);
    leaf.material = 0;
    kit.root(kit.scene.solids.add_leaf(leaf));
    return kit;
}

TEST(Plate, OnASheetWithoutThicknessHasTwoSides) {
    SceneKit kit = open_sheet();
    kit.light("point_light", {{"intensity", {4}}}, Affine::translation({0, 0, 2}));
    kit.light("point_light", {{"intensity", {1}}}, Affine::translation({0, 0, -1}));
    const CommittedScene scene = kit.commit();
    EXPECT_NEAR(measured(scene, {0.5, 0.25, 0}, {0, 0, 1}).value.g, 4 * 2 / std::pow(4.3125, 1.5), 1e-5);
    EXPECT_NEAR(measured(scene, {0.5, 0.25, 0}, {0, 0, -1}).value.g, 1 / std::pow(1.3125, 1.5), 1e-5);
    EXPECT_FALSE(measured(scene, {0.5, 0.25, 0}, {0, 0, -1}).buried);
}

TEST(Plate, OnALampMeasuresWhatArrivesThere) {
    SceneKit kit;
    kit.light("area_light", {{"size", {2, 2}}, {"radiance", {5}}}, Affine::translation({0, 0, 2}));
    kit.light("point_light", {{"intensity", {4}}});
    kit.light("point_light", {{"intensity", {3}}}, Affine::translation({0, 0, 3}));
    kit.light("sphere_light", {{"r", {1}}}, Affine::translation({20, 0, 0}));
    kit.light("point_light", {{"intensity", {2}}}, Affine::translation({20, 0, 2}));
    const CommittedScene scene = kit.commit();
    EXPECT_NEAR(measured(scene, {0, 0, 2}, {0, 0, -1}).value.g, 1, 0.01);  // below: its front
    EXPECT_NEAR(measured(scene, {0, 0, 2}, {0, 0, 1}).value.g, 3, 0.01);   // above: its back
    EXPECT_NEAR(measured(scene, {20, 0, 1}, {0, 0, 1}).value.g, 2, 0.02);  // on the ball
    EXPECT_TRUE(measured(scene, {20, 0, 0.5}, {0, 0, 1}).buried);
    EXPECT_FALSE(measured(scene, {0, 0, 1.9}, {0, 0, -1}).buried);
}

TEST(Plate, InsideAnOpaqueSolidGetsNothing) {
    SceneKit kit = box_under_sky(1);
    kit.light("point_light", {{"intensity", {4}}}, Affine::translation({1, 1, 1}));
    Leaf ground;
    ground.kind = LeafKind::half_space;
    ground.to_world = Affine::translation({0, 0, -1});
    ground.material = 0;
    kit.root(kit.scene.solids.add_leaf(ground));
    const CommittedScene scene = kit.commit();
    for (const Vec3d p : {Vec3d{1, 1, 0.5}, {0.1, 0.1, 1.99}, {9, 9, -2}, {5, 5, -1.1}})
        for (const Vec3d d : {Vec3d{0, 0, 1}, {0, 0, -1}, {1, 2, 3}}) {
            const Reading r = measured(scene, p, d);
            EXPECT_TRUE(r.buried);
            EXPECT_EQ(r.value, Rgb{});
            EXPECT_EQ(r.samples, 0U);
        }
    EXPECT_TRUE(measured(scene, {1, 1, 2}, {0, 0, -1}).buried);
    EXPECT_TRUE(measured(scene, {5, 5, -1}, {0, 0, -1}).buried);
    EXPECT_FALSE(measured(scene, {5, 5, -1}, {0, 0, 1}).buried);
    EXPECT_FALSE(measured(scene, {5, 5, -0.9}, {0, 0, -1}).buried);
}

TEST(Plate, BetweenTwoSolidsThatTouchIsBuried) {
    SceneKit kit = box_under_sky(1);
    kit.root(kit.box({0.5, 0.5, 2}, {1.5, 1.5, 3}, 0));
    const CommittedScene scene = kit.commit();
    EXPECT_TRUE(measured(scene, {1, 1, 2}, {0, 0, 1}).buried);
    EXPECT_FALSE(measured(scene, {0.2, 0.2, 2}, {0, 0, 1}).buried);
}

TEST(Plate, InGlassHasItsMediumOnBothSides) {
    SceneKit kit;
    const std::uint32_t glass = kit.material("glass", "dielectric", {{"ior", {1.5}}});
    kit.root(kit.box({-1, -1, -1}, {1, 1, 1}, glass));
    const CommittedScene scene = kit.commit();
    const PlateFinder finder(scene);
    const Plate inside = finder.place({0.1, 0.2, 0.3}, {0, 0, 1});
    EXPECT_FALSE(inside.buried);
    EXPECT_EQ(inside.point.front->ior, 1.5F);
    EXPECT_EQ(inside.point.back->ior, 1.5F);
    EXPECT_EQ(inside.point.id, FaceId{});
    const Plate top = finder.place({0.1, 0.2, 1}, {0, 0, 1}), bottom = finder.place({0.1, 0.2, 1}, {0, 0, -1});
    EXPECT_EQ(top.point.front->ior, 1);
    EXPECT_EQ(top.point.back->ior, 1.5F);
    EXPECT_EQ(bottom.point.back->ior, 1.5F);
    EXPECT_EQ(top.point.id, bottom.point.id);
    EXPECT_FALSE(bottom.buried);
    EXPECT_EQ(bottom.horizon, Vec3{});
}

}  // namespace
}  // namespace cardioid

#include "rt_core/render/committed_scene.hpp"

#include <gtest/gtest.h>

#include "scene_kit.hpp"

#include "rt_core/render/commit/scene_digest.hpp"

namespace cardioid {
namespace {

using test::SceneKit;

std::string bad_input(const SceneKit& kit) {
    try {
        static_cast<void>(kit.commit());
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_input);
        return error.what();
    }
    ADD_FAILURE() << "nothing thrown";
    return {};
}

TEST(CommittedScene, NamesTheNearestShader) {
    SceneKit kit;
    kit.material("shiny", "phogn", {});
    EXPECT_EQ(bad_input(kit), "test.csg:1:1: no shader \"phogn\" (did you mean \"phong\"?)");
}

TEST(CommittedScene, NamesTheNearestLight) {
    SceneKit kit;
    kit.light("poin_light", {});
    EXPECT_EQ(bad_input(kit), "test.csg:1:1: no light \"poin_light\" (did you mean \"point_light\"?)");
}

TEST(CommittedScene, RefusesMaterialsThatAreMadeOfThemselves) {
    SceneKit kit;
    kit.material("a", "checker", {});
    kit.material("b", "checker", {});
    kit.scene.materials[1].params.set("a", std::string("b"));
    kit.scene.materials[2].params.set("a", std::string("a"));
    EXPECT_NE(bad_input(kit).find("made of itself"), std::string::npos);
}

TEST(CommittedScene, TakesEmissionOnEveryKindOfMaterial) {
    SceneKit kit;
    const std::uint32_t glow = kit.material("glow", "plastic", {{"emission", {1, 2, 3}}});
    kit.root(kit.ball({0, 0, 0}, 1, glow));
    const CommittedScene scene = kit.commit();
    const SurfacePoint point = test::seen(scene, {0, -5, 0}, {0, 1, 0});
    EXPECT_EQ(scene.emitted(point, {0, -1, 0}), (Rgb{1, 2, 3}));
    EXPECT_EQ(scene.emitted(point, {0, 1, 0}), (Rgb{}));
    EXPECT_EQ(scene.lights().size(), 1U);
}

TEST(CommittedScene, GivesADarkSceneTheStudioUnlessToldNotTo) {
    SceneKit kit;
    kit.root(kit.ball({0, 0, 0}, 1, 0));
    kit.material("unused", "emitter", {{"emission", {1}}});
    EXPECT_EQ(kit.commit({.studio = true}).lights().size(), 2U);
    const CommittedScene dark = kit.commit({.studio = false});
    EXPECT_TRUE(dark.lights().empty());
    ASSERT_EQ(dark.warnings().size(), 1U);
    EXPECT_NE(dark.warnings()[0].find("no light"), std::string::npos);
    kit.light("point_light", {{"intensity", {1}}});
    EXPECT_EQ(kit.commit({.studio = true}).lights().size(), 1U);
}

TEST(CommittedScene, LaysTheGroundJustUnderTheModel) {
    SceneKit kit;
    kit.root(kit.box({-1, -1, 2}, {1, 1, 4}, 0));
    const CommittedScene scene = kit.commit({.studio = true, .ground = true});
    const SurfacePoint ground = test::seen(scene, {100, 100, 50}, {0, 0, -1});
    EXPECT_LT(ground.p.z, 2);
    EXPECT_GT(ground.p.z, 1.99);
    EXPECT_EQ(ground.ng, (Vec3{0, 0, 1}));
    EXPECT_EQ(scene.bounds().lo.z, 2);
}

TEST(CommittedScene, ReportsALampAsItsLightAndBlack) {
    SceneKit kit;
    kit.light("point_light", {{"intensity", {1}}});
    kit.light("disk_light", {{"r", {1}}, {"radiance", {5}}}, Affine::translation({0, 0, 3}));
    const CommittedScene scene = kit.commit();
    const SurfacePoint lamp = test::seen(scene, {0, 0, 0}, {0, 0, 1});
    EXPECT_EQ(lamp.lamp, 1);
    EXPECT_EQ(scene.emitted(lamp, {0, 0, -1}), Rgb(5));
    BsdfMemory memory;
    EXPECT_EQ(scene.bsdf(lamp, memory)->lobes(), Lobe::none);
    const SurfacePoint behind = test::seen(scene, {0, 0, 9}, {0, 0, -1});
    EXPECT_EQ(behind.lamp, 1);
    EXPECT_EQ(scene.emitted(behind, {0, 0, 1}), Rgb{});
}

TEST(CommittedScene, HashesGeometryMaterialsAndLightsAlone) {
    SceneKit kit;
    kit.root(kit.ball({0, 0, 0}, 1, 0));
    kit.light("point_light", {{"intensity", {1}}});
    const std::uint64_t first = scene_hash(kit.scene);
    EXPECT_EQ(kit.commit().hash(), kit.commit().hash());
    const auto changed = [&](auto&& change) {
        SceneKit other = kit;
        change(other.scene);
        return scene_hash(other.scene) != first;
    };
    EXPECT_TRUE(changed([](Scene& s) { s.solids.leaves[0].to_world.t.x = 1e-9; }));
    EXPECT_TRUE(changed([](Scene& s) { s.materials[0].kind = "mirror"; }));
    EXPECT_TRUE(changed([](Scene& s) { s.materials[0].params.set("reflectance", 0.6); }));
    EXPECT_TRUE(changed([](Scene& s) { s.lights[0].to_world.t.z = 3; }));
    EXPECT_FALSE(changed([](Scene& s) { s.film.samples = 7; }));
    EXPECT_FALSE(changed([](Scene& s) { s.cameras.emplace_back(); }));
    EXPECT_FALSE(changed([](Scene& s) { s.solids.leaves[0].to_world.t.x = -0.0; }));
}

TEST(CommittedScene, CountsFaces) {
    SceneKit kit;
    kit.root(kit.ball({0, 0, 0}, 1, 0));
    kit.root(kit.box({0, 0, 0}, {1, 1, 1}, 0));
    EXPECT_EQ(kit.commit().face_count(), 7U);
}

TEST(CommittedScene, IsCommittedWithNothingInIt) {
    const CommittedScene scene = SceneKit().commit({.studio = true});
    EXPECT_FALSE(scene.intersect({{0, 0, 5}, {0, 0, -1}, Box3d::infinity, {}, {}}).found());
    EXPECT_TRUE(scene.bounds().empty());
    ASSERT_EQ(scene.warnings().size(), 1U);
}

}  // namespace
}  // namespace cardioid

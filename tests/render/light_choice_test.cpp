#include "rt_core/render/lighting/light_choice.hpp"

#include <gtest/gtest.h>

#include "scene_kit.hpp"

namespace cardioid {
namespace {

using test::SceneKit;

/// Lamps of several kinds in a row, a sun, a sky, and a lamp without power.
SceneKit many_lights() {
    SceneKit kit;
    kit.root(kit.box({-9, -9, -1}, {9, 9, 0}, 0));
    kit.root(kit.ball({3, 3, 3}, 0.5, kit.material("glow", "emitter", {{"emission", {2}}})));
    for (int i = 0; i < 9; ++i)
        kit.light("point_light", {{"intensity", {1.0 + i}}}, Affine::translation({i - 4.0, 0.3 * i, 2}));
    kit.light("area_light", {{"size", {1, 2}}, {"radiance", {1}}}, Affine::translation({0, 4, 3}));
    kit.light("sun", {{"direction", {0, 0, -1}}});
    kit.light("sky", {{"radiance", {0.2}}});
    kit.light("point_light", {{"intensity", {0}}}, Affine::translation({0, 0, 1}));
    return kit;
}

TEST(LightChoice, DrawsEachLightWithTheChanceItTells) {
    const SceneKit kit = many_lights();
    const CommittedScene scene = kit.commit();
    const LightChoice choice(scene);
    const std::size_t lights = scene.lights().size();
    for (const Vec3d p : {Vec3d{0, 0, 0}, {-4, 0, 1.9}, {100, 0, 5}}) {
        double sum = 0;
        for (std::size_t i = 0; i < lights; ++i) sum += static_cast<double>(choice.chance(p, i));
        EXPECT_NEAR(sum, 1, 1e-5);
        constexpr int n = 100'000;
        std::vector<int> drawn(lights);
        for (int i = 0; i < n; ++i) {
            const auto [light, chance] = choice.choose(p, (static_cast<float>(i) + 0.5F) / n);
            EXPECT_NEAR(chance, choice.chance(p, light), 1e-6);
            ++drawn[light];
        }
        // Evenly spread numbers: each way is taken as often as it should be but for its ends.
        for (std::size_t i = 0; i < lights; ++i) EXPECT_NEAR(drawn[i], n * static_cast<double>(choice.chance(p, i)), 8);
    }
}

TEST(LightChoice, PrefersWhatIsNear) {
    const SceneKit kit = many_lights();
    const CommittedScene scene = kit.commit();
    const LightChoice choice(scene);
    EXPECT_GT(choice.chance({-4, 0, 1.9}, 0), 0.2F);  // a fiftieth of all power
    EXPECT_LT(choice.chance({4, 2.4, 1.9}, 0), 0.05F);
    EXPECT_EQ(choice.chance({0, 0, 0}, 12), 0) << "a lamp without power";
}

TEST(LightChoice, HasNothingToChooseWhereThereIsNoLight) {
    const SceneKit kit;
    const CommittedScene scene = kit.commit();
    EXPECT_EQ(LightChoice(scene).choose({}, 0.5F).chance, 0);
    EXPECT_FALSE(LightChoice(scene).several());
}

}  // namespace
}  // namespace cardioid

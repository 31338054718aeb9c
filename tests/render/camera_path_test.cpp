#include "rt_core/render/camera_path.hpp"

#include <gtest/gtest.h>

#include "scene_kit.hpp"

#include "rt_core/render/lighting/direct_lighting.hpp"

namespace cardioid {
namespace {

// Everything shines alike, so that what a sample brings is what Russian roulette made of its chains. Raised to the
// whole of what the eye gets, or to that within glass, a chain that carried a thousandth is a speck.
TEST(CameraPath, HasNoSpecksInGlass) {
    test::SceneKit kit;
    const auto glass = kit.material("glass", "dielectric", {{"ior", {1.5}}});
    kit.root(kit.ball({0, 0, 0}, 1, glass));
    kit.light("sky", {{"radiance", {1}}});
    const CommittedScene scene = kit.commit();
    const auto module = direct_lighting.make({}, 0);
    Progress progress;
    module->prepare(scene, nullptr, progress);
    constexpr std::uint32_t offsets = 32, samples = 500;
    double sum = 0;
    float most = 0;
    for (std::uint32_t i = 0; i < offsets; ++i) {
        const Vec3d o{(i + 0.5) / offsets, -5, 0};
        const EyeRay eye{{o, {0, 1, 0}, Box3d::infinity, {}, {}}, scene.medium_at(o)};
        for (std::uint32_t j = 0; j < samples; ++j) {
            Sampler sampler(3, Purpose::test, i, j);
            const float L = light_along(scene, *module, eye, sampler).sum().g;
            sum += double{L};
            most = std::max(most, L);
        }
    }
    EXPECT_LT(most, 1.1F);
    EXPECT_NEAR(sum / (offsets * samples), 1, 1e-3);
}

}  // namespace
}  // namespace cardioid

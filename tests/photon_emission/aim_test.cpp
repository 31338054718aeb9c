#include "photon/emission/aim.hpp"

#include <gtest/gtest.h>

#include "emission_kit.hpp"

namespace cardioid {
namespace {

using photon::Aim;
using photon::Keep;
using photon::Pass;
using photon::Shot;
using test::SceneKit;

/// A small glass ball in a large room, lit by one kind of light.
SceneKit marble(const std::string& light, std::initializer_list<std::pair<const char*, std::vector<double>>> values) {
    SceneKit kit;
    kit.root(test::room(kit, {0, 0, 0}, {4, 4, 4}, 0));
    kit.root(kit.ball({1, 1.2, 0.5}, 0.25, kit.material("glass", "dielectric", {{"ior", {1.5}}})));
    kit.light(light, values, Affine::translation({2, 2, 3.9}));
    return kit;
}

SceneKit marbles[] = {marble("point_light", {{"power", {1, 1, 1}}}),
                      marble("area_light", {{"size", {0.5, 0.5}}, {"power", {1, 1, 1}}}),
                      marble("sphere_light", {{"r", {0.05}}, {"power", {1, 1, 1}}}),
                      marble("spot_light", {{"power", {1, 1, 1}}, {"angle", {60}}})};

Shot shoot_caustics(const World& world, std::uint64_t count, const Aim* aim) {
    Progress progress;
    return photon::shoot(world, {}, {3, Pass::caustic, Keep::caustics, count, aim}, progress);
}

TEST(Aim, SendsMostPhotonsWhereTheyMakeCausticsAndKeepsTheirFlux) {
    for (const SceneKit& kit : marbles) {
        SCOPED_TRACE(kit.scene.lights[0].kind);
        const CommittedScene scene = kit.commit();
        Progress progress;
        const Aim aim = photon::find_aim(scene, {}, 1, 1 << 16, progress);
        const Shot even = shoot_caustics(scene, 200'000, nullptr), aimed = shoot_caustics(scene, 25'000, &aim);
        const double share_even = static_cast<double>(even.ledger.caustic_paths) / 200'000;
        const double share_aimed = static_cast<double>(aimed.ledger.caustic_paths) / 25'000;
        EXPECT_GT(share_aimed, 8 * share_even);
        EXPECT_NEAR(aimed.ledger.emitted.g, 1, 0.01);
        const double sigma = 1.5 / std::sqrt(static_cast<double>(even.ledger.caustic_paths));
        EXPECT_NEAR(aimed.ledger.stored[1].g / even.ledger.stored[1].g, 1, 4 * sigma);
        EXPECT_NEAR(aim.share, share_even, 0.2 * share_even);
        EXPECT_LT(aimed.ledger.gap(), 1e-6);
    }
}

TEST(Aim, DividesEveryLightWithoutGapsOrOverlap) {
    for (const SceneKit& kit : marbles) {
        Progress progress;
        const Aim aim = photon::find_aim(kit.commit(), {}, 1, 1 << 14, progress);
        double volume = 0;
        for (const photon::AimCell& cell : aim.cells) {
            volume += cell.volume();
            EXPECT_GT(cell.density, 0);
        }
        EXPECT_NEAR(volume, 1, 1e-9);
        EXPECT_GT(aim.cells.size(), 4U);
    }
}

TEST(Aim, IsEmptyWhereNothingMakesCaustics) {
    Progress progress;
    const Aim aim =
        photon::find_aim(test::lit_room("diffuse", {{"reflectance", {0.5, 0.5, 0.5}}}).commit(), {}, 1, 4096, progress);
    EXPECT_TRUE(aim.empty());
    EXPECT_EQ(aim.paths, 4096U);
}

// Photons in cells of low density are the heavy ones: they must be few.
TEST(Aim, LeavesFewHeavyPhotons) {
    const CommittedScene scene = marbles[0].commit();
    Progress progress;
    const Aim aim = photon::find_aim(scene, {}, 1, 1 << 17, progress);
    const Shot shot = shoot_caustics(scene, 100'000, &aim);
    double sum = 0, squares = 0;
    for (const photon::Photon& p : shot.photons) {
        const double f = double{test::flux(shot, p).g};
        sum += f, squares += f * f;
    }
    const double n = static_cast<double>(shot.photons.size());
    EXPECT_LT(squares * n / (sum * sum), 1.5);
}

}  // namespace
}  // namespace cardioid

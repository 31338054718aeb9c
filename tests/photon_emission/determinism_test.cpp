#include <cstring>
#include <gtest/gtest.h>
#include <omp.h>

#include "emission_kit.hpp"

namespace cardioid {
namespace {

using photon::Shot;
using test::SceneKit;

SceneKit room_with_glass() {
    SceneKit kit = test::lit_room("plastic", {{"reflectance", {0.7, 0.5, 0.3}}, {"roughness", {0.3}}});
    const auto glass =
        kit.material("glass", "dielectric", {{"ior", {1.5}}, {"absorption", {1, 0.5, 0.1}}, {"roughness", {0.2}}});
    kit.root(kit.ball({0.5, 0.5, 0.25}, 0.2, glass));
    kit.root(kit.ball({0.8, 0.8, 0.8}, 0.1, kit.material("glow", "diffuse", {{"emission", {1, 1, 1}}})));
    kit.light("area_light", {{"size", {0.4, 0.4}}, {"power", {1, 1, 1}}}, Affine::translation({0.5, 0.5, 0.99}));
    return kit;
}

bool same(const Shot& a, const Shot& b) {
    return a.photons.size() == b.photons.size() &&
           std::memcmp(a.photons.data(), b.photons.data(), a.photons.size() * sizeof(photon::Photon)) == 0 &&
           a.ledger.absorbed.r == b.ledger.absorbed.r && a.ledger.absorbed.b == b.ledger.absorbed.b &&
           a.ledger.rays == b.ledger.rays;
}

TEST(Shot, HasTheSameBitsForAnyNumberOfThreads) {
    const CommittedScene scene = room_with_glass().commit();
    const int before = omp_get_max_threads();
    Progress progress;
    const auto with_threads = [&](int threads) {
        omp_set_num_threads(threads);
        const photon::Aim aim = photon::find_aim(scene, {}, 1, 10'000, progress);
        std::vector<Shot> shots;
        shots.push_back(test::shoot(scene, 20'000));
        shots.push_back(
            photon::shoot(scene, {}, {1, photon::Pass::caustic, photon::Keep::caustics, 20'000, &aim}, progress));
        return shots;
    };
    const std::vector<Shot> one = with_threads(1);
    for (const int threads : {2, 7}) {
        const std::vector<Shot> more = with_threads(threads);
        EXPECT_TRUE(same(one[0], more[0])) << threads;
        EXPECT_TRUE(same(one[1], more[1])) << threads;
    }
    omp_set_num_threads(before);
    EXPECT_FALSE(same(one[0], test::shoot(scene, 20'000, {}, photon::Keep::everything, 2)));
}

// A model a thousand times larger has the same photons in the same places.
TEST(Shot, DoesNotDependOnTheUnitOfLength) {
    const auto scaled = [](double s) {
        SceneKit kit;
        kit.root(kit.scene.solids.add_node(SolidOp::subtract, {kit.box(Vec3d{-1, -1, -1} * s, Vec3d{2, 2, 2} * s, 0),
                                                               kit.box({}, Vec3d{1, 1, 1} * s, 0)}));
        kit.light("point_light", {{"power", {1, 1, 1}}}, Affine::translation(Vec3d{0.5, 0.4, 0.6} * s));
        return test::shoot(kit.commit(), 5000);
    };
    const Shot small = scaled(1), large = scaled(1024);
    ASSERT_EQ(small.photons.size(), large.photons.size());
    for (std::size_t i = 0; i < small.photons.size(); ++i) {
        ASSERT_LT(length(test::place(large, large.photons[i]) / 1024.0 - test::place(small, small.photons[i])), 1e-5);
        ASSERT_EQ(small.photons[i].flux, large.photons[i].flux);
    }
}

class Impatient final : public Progress {
public:
    [[nodiscard]] bool interrupted() const noexcept override { return true; }
};

TEST(Shot, EndsSoonOnceInterrupted) {
    const CommittedScene scene = room_with_glass().commit();
    Impatient progress;
    EXPECT_EQ(photon::shoot(scene, {}, {.count = 100'000'000}, progress).ledger.paths, 0U);
}

}  // namespace
}  // namespace cardioid

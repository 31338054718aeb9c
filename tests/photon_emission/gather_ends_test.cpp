#include "photon/gather/gather_ends.hpp"

#include <gtest/gtest.h>

#include "emission_kit.hpp"

namespace cardioid {
namespace {

using test::SceneKit;
using test::StaringEye;

/// A unit room in the dark beside one with a lamp.
SceneKit two_rooms() {
    SceneKit kit;
    const auto wall = kit.material("wall", "diffuse", {{"reflectance", {0.5, 0.5, 0.5}}});
    kit.root(kit.scene.solids.add_node(SolidOp::subtract,
                                       {kit.box({-1, -1, -1}, {4, 2, 2}, wall), kit.box({0, 0, 0}, {1, 1, 1}, wall),
                                        kit.box({2, 0, 0}, {3, 1, 1}, wall)}));
    kit.light("point_light", {{"power", {1000, 1000, 1000}}}, Affine::translation({2.5, 0.5, 0.5}));
    return kit;
}

// Of the cosine-weighted hemisphere about the middle of a cube's floor the ceiling has 0.2394 (two rectangles' corners,
// configuration factor of a parallel plate).
TEST(GatherEnds, AreAsManyAsRaysFallThereHoweverDark) {
    SceneKit kit = two_rooms();
    const CommittedScene world = kit.commit();
    const StaringEye eye(world, {{0.5, 0.5, 0.5}, {0, 0, -1}});
    constexpr std::size_t count = 40'000;
    const Vec3d origin{0.25, 0, 0};
    const auto ends = photon::gather_ends(world, eye, 3, count, origin);
    ASSERT_EQ(ends.size(), count);
    double ceiling = 0;
    for (const photon::Photon& end : ends) {
        const Vec3d p = origin + Vec3d(end.p);
        ASSERT_TRUE(p.x > -1e-5 && p.x < 1 + 1e-5) << p.x;
        if (p.z < 1 - 1e-5) continue;
        ++ceiling;
        EXPECT_LT(photon::decode_direction(end.n).z, -0.99F);
        EXPECT_LT(photon::decode_direction(end.wi).z, 0);
    }
    constexpr double share = 0.23940;
    const double sigma = std::sqrt(share * (1 - share) / count);
    EXPECT_GT(test::p_of_z((ceiling / count - share) / sigma), 1e-4) << ceiling / count;
    EXPECT_LT(test::p_of_z((ceiling / count - 1.05 * share) / sigma), 1e-4) << "5 % would be seen";
}

TEST(GatherEnds, EndWhereNothingIsSeen) {
    SceneKit kit;
    kit.root(kit.box({-1, -1, -1}, {1, 1, 0}, kit.material("floor", "diffuse", {})));
    const CommittedScene world = kit.commit();
    const StaringEye eye(world, {{0, 0, 1}, {0, 0, -1}});
    EXPECT_TRUE(photon::gather_ends(world, eye, 1, 1000, {}).empty());
}

}  // namespace
}  // namespace cardioid

#include "rt_core/trace/lamp_region.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace cardioid {
namespace {

const LampShape plate{LampShape::Kind::rectangle, Affine::translation({0, 0, 5}), {2, 4}};

TEST(LampRegion, APlateIsMetWithinItsEdgesFromBothSides) {
    const LampRegion lamp(plate);
    Hit hit;
    ASSERT_TRUE(lamp.first_boundary({{0.9, 1.9, 0}, {0, 0, 1}, 1e9, {}, {}}, 7, hit));
    EXPECT_EQ(hit.t, 5);
    EXPECT_EQ(hit.ng, Vec3(0, 0, -1));
    EXPECT_TRUE(lamp.first_boundary({{0.9, -1.9, 9}, {0, 0, -1}, 1e9, {}, {}}, 7, hit));
    EXPECT_EQ(hit.ng, Vec3(0, 0, -1));  // the front, wherever it is seen from
    EXPECT_FALSE(lamp.first_boundary({{1.1, 0, 0}, {0, 0, 1}, 1e9, {}, {}}, 7, hit));
    EXPECT_FALSE(lamp.first_boundary({{0, 2.1, 0}, {0, 0, 1}, 1e9, {}, {}}, 7, hit));
    EXPECT_FALSE(lamp.first_boundary({{0, 0, 0}, {0, 0, 1}, 4.9, {}, {}}, 7, hit));
}

TEST(LampRegion, ItsOwnRaysAreNotTrapped) {
    const LampRegion lamp(plate);
    Hit hit;
    EXPECT_FALSE(lamp.first_boundary({{0, 0, 5}, {0, 0, -1}, 1e9, {7, 0}, {0, 0, -1}}, 7, hit));
    const LampRegion ball({LampShape::Kind::sphere, Affine::scaling({2, 2, 2}), {0.5, 0}});
    EXPECT_FALSE(ball.first_boundary({{1, 0, 0}, Vec3d{1, 0.1, 0}, 1e9, {7, 0}, {1, 0, 0}}, 7, hit));
    EXPECT_TRUE(ball.first_boundary({{3, 0, 0}, {-1, 0, 0}, 1e9, {}, {}}, 7, hit));
    EXPECT_NEAR(hit.t, 2, 1e-12);
    EXPECT_EQ(hit.ng, Vec3(1, 0, 0));
}

TEST(LampRegion, ABallIsSeenFromInsideToo) {
    const LampRegion ball({LampShape::Kind::sphere, {}, {1, 0}});
    Hit hit;
    ASSERT_TRUE(ball.first_boundary({{0.5, 0, 0}, {1, 0, 0}, 1e9, {}, {}}, 0, hit));
    EXPECT_NEAR(hit.t, 0.5, 1e-12);
    EXPECT_TRUE(ball.sides({0.5, 0, 0}, {1, 0, 0}).back);
}

TEST(LampRegion, BoundsContainTurnedPlatesAndDiscs) {
    const double c = std::numbers::sqrt2 / 2;
    const Affine turned{{Vec3d{c, -c, 0}, {c, c, 0}, {0, 0, 1}}, {1, 2, 3}};
    const Box3d box = LampRegion({LampShape::Kind::rectangle, turned, {2, 2}}).bounds();
    EXPECT_NEAR(box.hi.x, 1 + 2 * c, 1e-12);
    EXPECT_NEAR(box.lo.z, 3, 1e-12);
    const Box3d disc = LampRegion({LampShape::Kind::disc, turned, {1, 0}}).bounds();
    EXPECT_GE(disc.hi.x, 2);
}

}  // namespace
}  // namespace cardioid

#include "csg/measure.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "csg/compile.hpp"

namespace cardioid::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A cube of side 2 scale about the origin, turned by 30 degrees about z, without a ball of radius 1.2 scale.
SolidTree pierced_cube(double scale) {
    const double c = std::cos(pi / 6) * scale, s = std::sin(pi / 6) * scale;
    const Affine turned{{Vec3d{c, -s, 0}, {s, c, 0}, {0, 0, scale}}, {}};
    SolidTree tree;
    const std::uint32_t cube =
        tree.add_leaf({LeafKind::box, turned * Affine::translation({-1, -1, -1}) * Affine::scaling({2, 2, 2})});
    const double r = 1.2 * scale;
    const std::uint32_t ball = tree.add_leaf({LeafKind::sphere, Affine::scaling({r, r, r})});
    tree.roots = {tree.add_node(SolidOp::subtract, {cube, ball})};
    return tree;
}

/// Of pierced_cube(1): the ball's six caps stand out of the cube.
double pierced_cube_volume() {
    const double h = 1.2 - 1, caps = 6 * pi * h * h * (3 * 1.2 - h) / 3;
    return 8 - (4.0 / 3 * pi * 1.2 * 1.2 * 1.2 - caps);
}

TEST(Volume, AgreesWithTheClosedFormForEightSeeds) {
    const auto region = csg::compile_whole(pierced_cube(1), false);
    double sum = 0;
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
        const csg::VolumeEstimate estimate = csg::measure_volume(*region, region->bounds(), 200, seed);
        const double z = (estimate.volume - pierced_cube_volume()) / estimate.sigma;
        EXPECT_LT(std::abs(z), 4) << seed;
        EXPECT_GT(std::abs(estimate.volume - 1.02 * pierced_cube_volume()), 4 * estimate.sigma) << seed;
        EXPECT_EQ(estimate.lines, 200 * 200);
        sum += z;
    }
    EXPECT_LT(std::abs(sum), 4 * std::sqrt(8.0));
}

TEST(Volume, GoesWithTheCubeOfTheScale) {
    const auto one = csg::compile_whole(pierced_cube(1), false), large = csg::compile_whole(pierced_cube(1e3), false);
    const double a = csg::measure_volume(*one, one->bounds(), 32, 1).volume;
    const double b = csg::measure_volume(*large, large->bounds(), 32, 1).volume;
    EXPECT_NEAR(b / a, 1e9, 1e9 * 1e-9);
}

TEST(Volume, IsInfiniteOfAnUnboundedSolidAndZeroInAnEmptyBox) {
    SolidTree tree;
    tree.roots = {tree.add_leaf({LeafKind::half_space, {}})};
    const auto region = csg::compile_whole(tree, false);
    EXPECT_FALSE(csg::measure_volume(*region, region->bounds(), 8, 0).bounded());
    EXPECT_EQ(csg::measure_volume(*region, Box3d{}, 8, 0).volume, 0);
    EXPECT_NEAR(csg::measure_volume(*region, {{0, 0, -3}, {1, 2, 5}}, 64, 0).volume, 6, 0.02);
}

TEST(Spans, OfALineThatBeginsInsideBeginAtZero) {
    const auto region = csg::compile_whole(pierced_cube(1), false);
    // Along z through the cube where the ball has a hole, and from within a corner.
    const auto through = csg::inside_spans(*region, {0, 0, -5}, {0, 0, 1}, 10);
    EXPECT_TRUE(through.empty());
    const Vec3d corner{std::cos(pi * 5 / 12) * 1.3, std::sin(pi * 5 / 12) * 1.3, 0};
    const auto inside = csg::inside_spans(*region, corner, {0, 0, 1}, 10);
    ASSERT_EQ(inside.size(), 1U);
    EXPECT_EQ(inside[0].begin, 0);
    EXPECT_NEAR(inside[0].end, 1, 1e-9);
}

TEST(Overlap, IsFoundWithItsSizeAndPlace) {
    const auto ball_at = [](Vec3d centre) {
        SolidTree tree;
        tree.roots = {tree.add_leaf({LeafKind::sphere, Affine::translation(centre)})};
        return csg::compile_whole(tree, false);
    };
    const auto a = ball_at({0, 0, 0}), b = ball_at({1, 0, 0}), touching = ball_at({0, 2, 0});
    const csg::Overlap overlap = csg::measure_overlap(*a, *b, a->bounds().intersection(b->bounds()), 32, 1e-5);
    EXPECT_NEAR(overlap.volume, 5 * pi / 12, 0.01 * 5 * pi / 12);  // a lens of two caps of height 1/2
    EXPECT_NEAR(length(overlap.where - Vec3d{0.5, 0, 0}), 0, 0.1);
    EXPECT_NEAR(overlap.depth, std::sqrt(3.0), 0.02);  // across the lens
    EXPECT_FALSE(csg::measure_overlap(*a, *touching, Box3d{{-1, 0.99, -1}, {1, 1.01, 1}}, 32, 1e-3).found());
}

}  // namespace
}  // namespace cardioid::test

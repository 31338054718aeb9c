#include "csg/measure_area.hpp"

#include <gtest/gtest.h>
#include <numbers>

#include "csg/compile.hpp"

namespace {

using namespace cardioid;

/// How many standard errors the measured area of these roots is from `area`.
double z_of(SolidTree& tree, std::uint32_t root, double area) {
    tree.roots = {root};
    const auto whole = csg::compile_whole(tree, false);
    const csg::AreaEstimate got = csg::measure_area(*whole, whole->bounds(), 1 << 16, 7);
    EXPECT_LT(got.sigma, 0.01 * area);
    return (got.area - area) / got.sigma;
}

TEST(MeasureArea, OfABallACubeAndACubeWithAHole) {
    SolidTree ball, cube, hollow;
    EXPECT_LT(std::abs(z_of(ball, ball.add_leaf({.kind = LeafKind::sphere}), 4 * std::numbers::pi)), 4);
    EXPECT_LT(std::abs(z_of(cube, cube.add_leaf({.kind = LeafKind::box}), 6)), 4);
    const std::uint32_t outer = hollow.add_leaf({.kind = LeafKind::box});
    const Affine middle = Affine::translation({0.25, 0.25, -1}) * Affine::scaling({0.5, 0.5, 3});
    const std::uint32_t hole = hollow.add_leaf({.kind = LeafKind::box, .to_world = middle});
    const std::uint32_t root = hollow.add_node(SolidOp::subtract, {outer, hole});
    EXPECT_LT(std::abs(z_of(hollow, root, 6 - 2 * 0.25 + 4 * 0.5)), 4);
    EXPECT_GT(std::abs(z_of(hollow, root, 1.02 * (6 - 2 * 0.25 + 4 * 0.5))), 4);  // 2 % are seen
}

}  // namespace

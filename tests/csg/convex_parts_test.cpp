#include "csg/region/convex_parts.hpp"

#include <gtest/gtest.h>

#include "tests/csg/models.hpp"

namespace cardioid::csg {
namespace {

using test::Random;

/// A turned box, a cone, a ball or a box; on whole numbers where `grid`, so that faces of several coincide.
Leaf convex_leaf(Random& random, bool grid) {
    if (grid) {
        const auto whole = [&](int lo, int hi) { return static_cast<double>(random.whole(lo, hi)); };
        const Vec3d lo{whole(0, 2), whole(0, 2), whole(0, 2)};
        if (random.whole(0, 2) == 0) return test::cone_leaf(lo + Vec3d{2, 2, 0}, whole(1, 3), whole(0, 3), whole(1, 4));
        return test::box_leaf(lo, {whole(1, 4), whole(1, 4), whole(1, 4)});
    }
    switch (random.whole(0, 2)) {
        case 0:
            return test::ball_leaf(random.point(0, 4), random(0.5, 4));
        case 1:
            return test::cone_leaf(random.point(0, 4), random(0.2, 3), random(0.2, 3), random(0.5, 5));
        default:
            return test::box_leaf(random.point(0, 3), random.point(0.5, 5));
    }
}

/// Up to three parts in common, less up to five cutters.
SolidTree random_and(unsigned seed, bool grid) {
    Random random(seed);
    SolidTree tree;
    std::vector<std::uint32_t> parts, all;
    for (int i = random.whole(1, 3); i > 0; --i) parts.push_back(tree.add_leaf(convex_leaf(random, grid)));
    all.push_back(tree.add_node(SolidOp::intersect, parts));
    for (int i = random.whole(0, 5); i > 0; --i) all.push_back(tree.add_leaf(convex_leaf(random, grid)));
    tree.roots = {tree.add_node(SolidOp::subtract, all)};
    return tree;
}

struct Told {
    int sure = 0, unsure = 0;
};

/// Compares with what the sweep says of the same ray.
void compare(const SolidRegion& region, const Ray& ray, Told& told) {
    std::vector<Boundary> all;
    region.boundaries(ray, all);
    Boundary quick;
    const Answer answer = first_by_intervals(region, ray, quick);
    ++(answer == Answer::unsure ? told.unsure : told.sure);
    if (answer == Answer::unsure) return;
    ASSERT_EQ(answer == Answer::found, !all.empty());
    if (all.empty()) return;
    ASSERT_EQ(quick.t, all[0].t);
    ASSERT_EQ(quick.input, all[0].input);
    ASSERT_EQ(quick.entering, all[0].entering);
    ASSERT_EQ(quick.ng, all[0].ng);
}

/// Rays from outside and inside, cut short at random, and from every boundary of each in another direction.
Told compare_models(bool grid) {
    Told told;
    for (unsigned seed = 1; seed <= 300; ++seed) {
        const auto region = test::whole(random_and(seed, grid), seed % 2 == 0);
        if (!region || !is_one_and_of_convex(region->gates(), region->leaves())) continue;
        Random random(seed);
        for (int i = 0; i < 60; ++i) {
            const Vec3d d = random.direction();
            const Vec3d target = grid && i % 4 == 0 ? Vec3d{double(i % 3), double(i % 5), 1} : random.point(0, 4);
            const Ray ray{i % 3 ? target - d * 20.0 : target, d, i % 5 ? 1e9 : random(0, 25), {}, {}};
            compare(*region, ray, told);
            std::vector<Boundary> all;
            region->boundaries(ray, all);
            for (const Boundary& b : all)
                compare(*region, {ray.o + d * b.t, random.direction(), 1e9, {0, b.input}, Vec3(b.ng)}, told);
        }
    }
    return told;
}

TEST(ConvexParts, SayWhatTheSweepSaysToTheLastBit) {
    const Told told = compare_models(false);
    EXPECT_GT(told.sure, 10000);
    EXPECT_LT(told.unsure, told.sure / 50);
}

TEST(ConvexParts, SayTheSameOrNothingWhereFacesCoincide) {
    const Told told = compare_models(true);
    EXPECT_GT(told.sure, 10000);
    EXPECT_GT(told.unsure, 100);
}

TEST(ConvexParts, AreNoUnionsAndNoTori) {
    SolidTree tree;
    const auto ball = tree.add_leaf(test::ball_leaf({0, 0, 0}, 1)), torus = tree.add_leaf(test::torus_leaf({}, 2, 1));
    tree.roots = {tree.add_node(SolidOp::unite, {ball, tree.add_leaf(test::ball_leaf({1, 0, 0}, 1))})};
    auto region = test::whole(tree, true);
    EXPECT_FALSE(is_one_and_of_convex(region->gates(), region->leaves()));
    tree.roots = {tree.add_node(SolidOp::subtract, {ball, torus})};
    region = test::whole(tree, true);
    EXPECT_FALSE(is_one_and_of_convex(region->gates(), region->leaves()));
}

}  // namespace
}  // namespace cardioid::csg

#include <gtest/gtest.h>

#include "tests/csg/models.hpp"

namespace cardioid::csg {
namespace {

using test::Random;

SolidTree random_model(unsigned seed, int depth) {
    Random random(seed);
    SolidTree tree;
    tree.roots = {test::random_tree(tree, random, depth, [&] { return test::random_leaf(random); })};
    return tree;
}

TEST(Sweep, AgreesWithTheDefinitionOfTheOperations) {
    int compared = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        const SolidTree tree = random_model(seed, seed % 2 ? 2 : 4);
        const auto region = test::whole(tree, false);
        Random random(seed);
        std::vector<Boundary> found;
        for (int i = 0; i < 200; ++i) {
            const Vec3d d = random.direction();
            const Ray ray{i % 2 ? random.point(0, 10) : random.point(0, 10) - d * 30.0, d, 1e9, {}, {}};
            const auto wanted = test::reference_boundaries(tree, ray);
            found.clear();
            if (region) region->boundaries(ray, found);
            ASSERT_EQ(found.size(), wanted.size()) << "seed " << seed << " ray " << i;
            for (std::size_t k = 0; k < wanted.size(); ++k) ASSERT_NEAR(found[k].t, wanted[k], 1e-9);
            compared += static_cast<int>(wanted.size());
        }
    }
    EXPECT_GT(compared, 3000);
}

TEST(Sweep, ARayThatLeavesASurfaceMeetsTheNextOneOnly) {
    int compared = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const auto region = test::whole(random_model(seed, 3), true);
        if (!region) continue;
        Random random(seed);
        std::vector<Boundary> all;
        for (int i = 0; i < 100; ++i) {
            const Vec3d d = random.direction();
            const Ray ray{random.point(0, 10) - d * 30.0, d, 1e9, {}, {}};
            region->boundaries(ray, all);
            for (std::size_t k = 0; k < all.size(); ++k) {
                const Ray on{ray.o + d * all[k].t, d, 1e9, {0, all[k].input}, Vec3(all[k].ng)};
                Hit hit;
                const bool more = region->first_boundary(on, 0, hit);
                ASSERT_EQ(more, k + 1 < all.size()) << "seed " << seed << " ray " << i << " boundary " << k;
                if (more) {
                    ASSERT_NEAR(hit.t, all[k + 1].t - all[k].t, 1e-8);
                }
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 1000);
}

TEST(Sweep, AReflectedRayLeavesAConvexSolidForGood) {
    SolidTree tree;
    tree.roots = {tree.add_node(SolidOp::intersect, {tree.add_leaf(test::ball_leaf({0, 0, 0}, 1000)),
                                                     tree.add_leaf(test::ball_leaf({100, 0, 0}, 1000))})};
    const auto region = test::whole(tree, true);
    Random random(3);
    std::vector<Boundary> all;
    for (int i = 0; i < 20000; ++i) {
        // Half of the rays graze.
        const Vec3d d = random.direction();
        Vec3d side = normalize(cross(d, random.direction()));
        const double miss = i % 2 ? random(0, 999) : 990 - std::pow(10, random(-9, 0));
        const Ray ray{side * miss - d * 5000.0, d, 1e9, {}, {}};
        region->boundaries(ray, all);
        if (all.empty()) continue;
        const Vec3d n = all[0].ng, out = d - n * (2 * dot(d, n));
        const Ray reflected{ray.o + d * all[0].t, out, 1e9, {0, all[0].input}, Vec3(n)};
        Hit hit;
        ASSERT_FALSE(region->first_boundary(reflected, 0, hit)) << i << " at " << hit.t;
    }
}

TEST(Sweep, NormalsPointOutOfTheSolidAndAreUnit) {
    for (unsigned seed = 1; seed <= 30; ++seed) {
        const auto region = test::whole(random_model(seed, 3), true);
        if (!region) continue;
        Random random(seed);
        std::vector<Boundary> all;
        for (int i = 0; i < 50; ++i) {
            const Vec3d d = random.direction();
            region->boundaries({random.point(0, 10) - d * 30.0, d, 1e9, {}, {}}, all);
            for (const Boundary& b : all) {
                EXPECT_NEAR(length(b.ng), 1, 1e-12);
                EXPECT_EQ(dot(b.ng, d) < 0, b.entering);
            }
        }
    }
}

TEST(Sweep, SidesOfASurfaceAgreeWithMembershipBesideIt) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const auto region = test::whole(random_model(seed, 3), true);
        if (!region) continue;
        Random random(seed);
        std::vector<Boundary> all;
        for (int i = 0; i < 50; ++i) {
            const Vec3d d = random.direction();
            const Ray ray{random.point(0, 10) - d * 30.0, d, 1e9, {}, {}};
            region->boundaries(ray, all);
            for (const Boundary& b : all) {
                if (std::abs(dot(b.ng, d)) < 0.1) continue;
                const Vec3d p = ray.o + d * b.t;
                const Sides sides = region->sides(p, b.ng);
                EXPECT_EQ(sides.front, region->contains(p + b.ng * 1e-3)) << seed << ' ' << i;
                EXPECT_EQ(sides.back, region->contains(p - b.ng * 1e-3)) << seed << ' ' << i;
            }
        }
    }
}

TEST(Sweep, TheMaximumDistanceIsExclusive) {
    SolidTree tree;
    tree.roots = {tree.add_leaf(test::box_leaf({0, 0, 0}, {1, 1, 1}))};
    const auto region = test::whole(tree, false);
    Hit hit;
    EXPECT_FALSE(region->first_boundary({{-1, 0.5, 0.5}, {1, 0, 0}, 1.0, {}, {}}, 0, hit));
    EXPECT_TRUE(region->first_boundary({{-1, 0.5, 0.5}, {1, 0, 0}, 1.0001, {}, {}}, 0, hit));
    EXPECT_EQ(hit.t, 1.0);
}

TEST(Sweep, AModelScaledByAThousandIsMetAtAThousandTimesTheDistance) {
    for (const double scale : {1e-3, 1e3}) {
        SolidTree small = random_model(5, 4), large = small;
        for (Leaf& leaf : large.leaves) leaf.to_world = Affine::scaling({scale, scale, scale}) * leaf.to_world;
        const auto a = test::whole(small, true), b = test::whole(large, true);
        Random random(9);
        std::vector<Boundary> ba, bb;
        for (int i = 0; i < 2000; ++i) {
            const Vec3d d = random.direction(), o = random.point(0, 10) - d * 30.0;
            a->boundaries({o, d, 1e12, {}, {}}, ba);
            b->boundaries({o * scale, d, 1e12, {}, {}}, bb);
            ASSERT_EQ(ba.size(), bb.size());
            for (std::size_t k = 0; k < ba.size(); ++k) ASSERT_NEAR(ba[k].t * scale, bb[k].t, 1e-9 * scale);
        }
    }
}

TEST(Sweep, FarOriginsLoseNoBoundary) {
    const SolidTree tree = random_model(7, 4);
    const auto region = test::whole(tree, true);
    Random random(1);
    std::vector<Boundary> near, far;
    for (int i = 0; i < 2000; ++i) {
        const Vec3d d = random.direction(), p = random.point(2, 8);
        region->boundaries({p - d * 20.0, d, 1e12, {}, {}}, near);
        region->boundaries({p - d * 1e5, d, 1e12, {}, {}}, far);
        ASSERT_EQ(near.size(), far.size()) << i;
    }
}

}  // namespace
}  // namespace cardioid::csg

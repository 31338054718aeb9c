#include <cmath>
#include <gtest/gtest.h>

#include "tests/language/read.hpp"

using namespace cardioid;
using cardioid::test::contains;
using cardioid::test::read;
using cardioid::test::tree_of;
using cardioid::test::warnings_of;

namespace {

Affine map_of(const std::string& transforms) { return read(transforms + " cube();").solids.leaves.at(0).to_world; }

void expect_near(Vec3d a, Vec3d b) { EXPECT_LT(length(a - b), 1e-12) << a.x << " " << a.y << " " << a.z; }

}  // namespace

TEST(Transforms, NestFromTheOutsideIn) {
    EXPECT_EQ(map_of("translate([1, 2, 3]) scale(2)").point({1, 1, 1}), Vec3d(3, 4, 5));
    EXPECT_EQ(map_of("scale(2) translate([1, 2, 3])").point({1, 1, 1}), Vec3d(4, 6, 8));
}

TEST(Transforms, RotateTurnsAboutXThenYThenZExactlyAtRightAngles) {
    EXPECT_EQ(map_of("rotate([90, 0, 90])").point({1, 2, 3}), Vec3d(3, 1, 2));
    EXPECT_EQ(map_of("rotate(90)").point({1, 2, 3}), Vec3d(-2, 1, 3));
    EXPECT_EQ(map_of("rotate(a = 180, v = [0, 0, -1])").point({1, 2, 3}), Vec3d(-1, -2, 3));
    expect_near(map_of("rotate(120, [1, 1, 1])").point({1, 2, 3}), {3, 1, 2});
    EXPECT_EQ(map_of("rotate(30, [0, 0, 0])"), Affine{});
}

TEST(Transforms, MirrorReflectsInThePlaneThroughTheOrigin) {
    EXPECT_EQ(map_of("mirror([2, 0, 0])").point({1, 2, 3}), Vec3d(-1, 2, 3));
    expect_near(map_of("mirror([1, 1, 0])").point({1, 2, 3}), {-2, -1, 3});
    EXPECT_EQ(map_of("mirror([0, 0, 0])"), Affine{});
    EXPECT_LT(map_of("mirror([1, 2, 3])").determinant(), 0);
}

TEST(Transforms, ScaleFillsMissingFactorsWithOne) {
    EXPECT_EQ(map_of("scale([2, 3])").point({1, 1, 1}), Vec3d(2, 3, 1));
    EXPECT_EQ(map_of("translate([2, 3])").point({0, 0, 0}), Vec3d(2, 3, 0));
}

TEST(Transforms, MissingEntriesOfAMatrixAreTheIdentityAndTheLastDivides) {
    EXPECT_EQ(map_of("multmatrix([[2, 0, 0, 5], [0, 3]])").point({1, 1, 1}), Vec3d(7, 3, 1));
    EXPECT_EQ(map_of("multmatrix(m = [[2, 0, 0, 4], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 2]])").point({1, 1, 1}),
              Vec3d(3, 1, 1));
    EXPECT_EQ(map_of("multmatrix()"), Affine{});
}

TEST(Transforms, WhatIsFlattenedOrNotFiniteIsRemovedWithAWarning) {
    for (const char* transform : {"scale([1, 1, 0])", "multmatrix([[1, 1, 0, 0], [1, 1, 0, 0], [0, 0, 1, 0]])",
                                  "multmatrix([[nan, 0, 0, 0]])", "translate([inf, 0, 0])", "rotate(inf)",
                                  "multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 0]])"}) {
        const Scene scene = read(std::string(transform) + " cube();");
        EXPECT_EQ(tree_of(scene), "") << transform;
        EXPECT_TRUE(contains(warnings_of(scene), "removed")) << transform;
    }
}

TEST(Transforms, TinyAndFlatIsNotFlattened) {
    EXPECT_EQ(tree_of(read("scale(1e-60) cube();")), "box");
    EXPECT_EQ(tree_of(read("scale([1, 1, 1e-9]) cube();")), "box");
}

TEST(Transforms, PlaneFiguresTakeTheUpperLeftPartOnly) {
    const Scene scene = read("linear_extrude(1) multmatrix([[1, 0, 5, 2], [0, 1, 5, 3], [9, 9, 0, 7]]) square(1);");
    ASSERT_EQ(tree_of(scene), "prism");
    EXPECT_EQ(scene.solids.profiles[0]->contours[0][0], Vec2d(2, 3));
}

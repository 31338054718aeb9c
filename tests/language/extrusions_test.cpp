#include <cmath>
#include <gtest/gtest.h>

#include "tests/language/read.hpp"

using namespace cardioid;
using cardioid::test::contains;
using cardioid::test::error_of;
using cardioid::test::read;
using cardioid::test::tree_of;
using cardioid::test::warnings_of;

namespace {

std::string tree(const std::string& text) { return tree_of(read(text)); }

ReadOptions facets() {
    ReadOptions out;
    out.openscad_facets = true;
    return out;
}

}  // namespace

TEST(LinearExtrude, OfATrueCircleIsACone) {
    const Leaf leaf = read("linear_extrude(height = 5, center = true) translate([1, 2]) circle(3);").solids.leaves[0];
    EXPECT_EQ(leaf.kind, LeafKind::cone);
    EXPECT_EQ(leaf.to_world.point({0, 0, 0}), Vec3d(1, 2, -2.5));
    EXPECT_EQ(leaf.to_world.point({1, 0, 1}), Vec3d(4, 2, 2.5));
}

TEST(LinearExtrude, ScalesTheTopAboutTheOriginNotTheCircle) {
    const Leaf leaf = read("linear_extrude(2, scale = 0.5) translate([4, 0]) circle(1);").solids.leaves[0];
    EXPECT_EQ(leaf.b, 0.5);
    EXPECT_EQ(leaf.to_world.point({0, 0, 1}), Vec3d(2, 0, 2));
    EXPECT_EQ(tree("linear_extrude(2, scale = 0) circle(1);"), "cone");
}

TEST(LinearExtrude, OfTooManySlicesIsRefusedBeforeItFillsTheMemory) {
    for (const char* text : {"linear_extrude(1, twist = 1e9) square(1);",
                             "linear_extrude(1, twist = 10, slices = 1e9) "
                             "circle(1, $fn = 64);"})
        EXPECT_TRUE(contains(error_of(text), "t.csg:1:1: linear_extrude() would make ")) << text;
}

TEST(LinearExtrude, OfFewEdgesIsAPrismAndOfManyAMesh) {
    EXPECT_EQ(tree("linear_extrude(5) square(2);"), "prism");
    EXPECT_EQ(tree("linear_extrude(5, scale = [2, 2]) square(2);"), "prism");
    EXPECT_EQ(tree("linear_extrude(5) difference() { square(9); circle(1, $fn = 8); }"), "prism");
    EXPECT_EQ(tree_of(read("linear_extrude(5) circle(1, $fn = 65);", facets())), "mesh");
    const Leaf leaf = read("linear_extrude(5, scale = [2, 2]) square(2);").solids.leaves[0];
    EXPECT_EQ(leaf.a, 2);
    EXPECT_EQ(leaf.to_world, Affine::scaling({1, 1, 5}));
}

TEST(LinearExtrude, TwistedUnevenOrPointedIsAClosedMesh) {
    for (const char* how :
         {"twist = 90", "twist = 90, slices = 7", "scale = [1, 2]", "scale = [0, 0]", "scale = [1, 0]", "scale = -1"}) {
        const Scene scene = read(std::string("linear_extrude(height = 5, ") + how + ") square(2);");
        ASSERT_EQ(tree_of(scene), "mesh") << how;
        EXPECT_TRUE(scene.solids.meshes[0]->closed) << how;
    }
}

TEST(LinearExtrude, WithoutHeightOrFigureIsNothing) {
    EXPECT_EQ(tree("linear_extrude(height = 0) square(1);"), "");
    EXPECT_EQ(tree("linear_extrude(height = -3) square(1);"), "");
    EXPECT_EQ(tree("linear_extrude(height = inf) square(1);"), "");
    EXPECT_EQ(tree("linear_extrude(height = 1);"), "");
    const Leaf leaf = read("linear_extrude() square(1);").solids.leaves[0];
    EXPECT_EQ(leaf.to_world.row[2].z, 100);
}

TEST(LinearExtrude, KnowsTheSpellingOfLaterVersions) {
    EXPECT_EQ(read("linear_extrude(height = 4, v = [0, 0, 1]) square(1);").solids.leaves[0].to_world.row[2].z, 4);
    EXPECT_TRUE(contains(error_of("linear_extrude(height = 4, v = [1, 0, 1]) square(1);"), "not supported yet"));
}

TEST(LinearExtrude, StartsAfreshInItsOwnPlane) {
    const Scene scene = read("rotate([90, 0, 0]) linear_extrude(1) translate([5, 0, 9]) square(1);");
    EXPECT_EQ(scene.solids.profiles[0]->contours[0][0], Vec2d(5, 0));
    EXPECT_EQ(scene.solids.leaves[0].to_world.point({0, 0, 1}), Vec3d(0, -1, 0));
}

TEST(RotateExtrude, OfATrueCircleOffTheAxisIsATorus) {
    const Leaf leaf = read("rotate_extrude() translate([10, 3]) circle(2);").solids.leaves[0];
    EXPECT_EQ(leaf.kind, LeafKind::torus);
    EXPECT_EQ(std::pair(leaf.a, leaf.b), std::pair(10.0, 2.0));
    EXPECT_EQ(leaf.to_world.t, Vec3d(0, 0, 3));
    EXPECT_EQ(tree("rotate_extrude() translate([-10, 3]) circle(2);"), "torus");
    EXPECT_EQ(tree("rotate_extrude() translate([10, 0]) scale([1, 2]) circle(2);"), "mesh") << "an ellipse is none";
}

TEST(RotateExtrude, OfFewEdgesIsARevolution) {
    EXPECT_EQ(tree("rotate_extrude() translate([3, 0]) square(2);"), "revolution");
    EXPECT_EQ(tree("rotate_extrude($fn = 48) square(2);"), "revolution");
    EXPECT_EQ(tree("rotate_extrude($fn = 12) square(2);"), "mesh");
    EXPECT_EQ(tree_of(read("rotate_extrude() square(2);", facets())), "mesh");
    const Scene left = read("rotate_extrude() translate([-3, 0]) square(2);");
    for (const Vec2d p : left.solids.profiles[0]->contours[0]) EXPECT_GE(p.x, 0);
}

TEST(RotateExtrude, BelowAWholeTurnIsCutByHalfSpaces) {
    EXPECT_EQ(tree("rotate_extrude(angle = 90) square(2);"), "(revolution&half&half)");
    EXPECT_EQ(tree("rotate_extrude(angle = 180) square(2);"), "(revolution&half)");
    EXPECT_EQ(tree("rotate_extrude(angle = 270) square(2);"), "(revolution-(half&half))");
    EXPECT_EQ(tree("rotate_extrude(angle = -90) translate([5, 0]) circle(1);"), "(torus&half&half)");
}

TEST(RotateExtrude, TheWedgeHoldsTheAnglesOfTheSweep) {
    for (const double angle : {30.0, 90.0, 180.0, 200.0, 270.0, 359.0, -45.0, -180.0, -300.0})
        for (const bool left : {false, true}) {
            const Scene scene = read("rotate_extrude(angle = " + std::to_string(angle) + ") translate([" +
                                     (left ? "-5" : "5") + ", 0]) square(1);");
            const auto inside = [&](double azimuth) {
                const double a = azimuth * std::acos(-1) / 180;
                bool wedge = true;
                for (const Leaf& leaf : scene.solids.leaves)
                    if (leaf.kind == LeafKind::half_space)
                        wedge = wedge && leaf.to_world.inverse().point({std::cos(a), std::sin(a), 0.5}).z <= 0;
                return wedge == (scene.solids.nodes[scene.solids.roots[0]].op == SolidOp::intersect);
            };
            for (double azimuth = -356.5; azimuth < 360; azimuth += 7) {
                const double turned = azimuth - (left ? 180 : 0);
                const double from_start = std::fmod((angle > 0 ? turned : -turned) + 720, 360);
                EXPECT_EQ(inside(azimuth), from_start < std::abs(angle)) << angle << " " << azimuth << " " << left;
            }
        }
}

TEST(RotateExtrude, AnglesOutOfRangeAreAWholeTurnAndZeroIsNothing) {
    EXPECT_EQ(tree("rotate_extrude(angle = 361) square(2);"), "revolution");
    EXPECT_EQ(tree("rotate_extrude(angle = -360) square(2);"), "revolution");
    EXPECT_EQ(tree("rotate_extrude(angle = nan) square(2);"), "revolution");
    EXPECT_EQ(tree("rotate_extrude(angle = 0) square(2);"), "");
}

TEST(RotateExtrude, AcrossTheAxisIsNothing) {
    const Scene scene = read("rotate_extrude() square(2, center = true);");
    EXPECT_EQ(tree_of(scene), "");
    EXPECT_TRUE(contains(warnings_of(scene), "both sides of the axis"));
    EXPECT_EQ(tree("rotate_extrude() circle(2);"), "");
}

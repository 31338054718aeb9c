#include <gtest/gtest.h>

#include "tests/language/read.hpp"

using namespace cardioid;
using cardioid::test::contains;
using cardioid::test::read;
using cardioid::test::tree_of;
using cardioid::test::warnings_of;

namespace {
std::string tree(const std::string& text) { return tree_of(read(text)); }
}  // namespace

TEST(Booleans, GroupsAreUnionsThatCostNothing) {
    EXPECT_EQ(tree("group() { union() { cube(); } render() { sphere(); } }"), "box ball");
    EXPECT_EQ(tree("group(); union();"), "");
}

TEST(Booleans, DifferenceTakesTheRestFromTheFirst) {
    EXPECT_EQ(tree("difference() { cube(); sphere(); cylinder(); }"), "(box-ball-cone)");
    EXPECT_EQ(tree("difference() { cube(); }"), "box");
    EXPECT_EQ(tree("difference() { group() { cube(); sphere(); } cylinder(); }"), "((box+ball)-cone)");
    EXPECT_EQ(tree("difference();"), "");
}

TEST(Booleans, AnEmptyFirstChildEmptiesADifference) {
    EXPECT_EQ(tree("difference() { group(); cube(); }"), "");
    EXPECT_EQ(tree("difference() { cube(size = [0, 0, 0]); cube(); }"), "");
    EXPECT_EQ(tree("difference() { linear_extrude() { } cube(); }"), "");
    EXPECT_EQ(tree("difference() { cube(); group(); sphere(); }"), "(box-ball)");
}

TEST(Booleans, AnyEmptyChildEmptiesAnIntersection) {
    EXPECT_EQ(tree("intersection() { cube(); sphere(); }"), "(box&ball)");
    EXPECT_EQ(tree("intersection() { cube(); group(); }"), "");
    EXPECT_EQ(tree("intersection() { group(); cube(); }"), "");
    EXPECT_EQ(tree("intersection();"), "");
}

TEST(Booleans, WhatPercentMarksIsNeverGeometry) {
    EXPECT_EQ(tree("difference() { %cube(); sphere(); cylinder(); }"), "(ball-cone)");
    EXPECT_EQ(tree("difference() { %group(); sphere(); cylinder(); }"), "(ball-cone)");
    EXPECT_EQ(tree("intersection() { %group(); sphere(); cylinder(); }"), "(ball&cone)");
    EXPECT_EQ(tree("difference() { sphere(); group() { %cube(); } }"), "ball");
    EXPECT_EQ(tree("%hull() cube(); sphere();"), "ball");
    EXPECT_EQ(tree("union() { %square(); cube(); }"), "box");
}

TEST(Booleans, WhatPercentMarksIsDrawnBesideTheModelWhereAskedFor) {
    ReadOptions options;
    options.show_background = true;
    const Scene scene = read("difference() { %color(\"red\") cube(); sphere(); cylinder(); }", options);
    EXPECT_EQ(tree_of(scene), "(ball-cone) box");
    const Leaf& backdrop = scene.solids.leaves[0];
    EXPECT_EQ(scene.materials[backdrop.material].kind, "filter");
}

TEST(Booleans, HighlightChangesNothing) { EXPECT_EQ(tree("difference() { #cube(); #sphere(); }"), "(box-ball)"); }

TEST(Booleans, WhatAStarMarksIsDropped) {
    EXPECT_EQ(tree("difference() { *cube(); sphere(); cylinder(); *nothing_known(); }"), "(ball-cone)");
}

TEST(Booleans, WhatAnExclamationMarkMarksIsTheModelWithAllLightsAndCameras) {
    const Scene scene = read("point_light(); translate([5, 0, 0]) { cube(); !sphere(); } camera([0, 0, 9]);");
    EXPECT_EQ(tree_of(scene), "ball");
    EXPECT_EQ(scene.solids.leaves[0].to_world.t, Vec3d(0, 0, 0));
    EXPECT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(scene.cameras.size(), 1U);
}

TEST(Booleans, TheFirstChildWithSubstanceSetsTheDimension) {
    const Scene flat = read("linear_extrude(1) union() { square(2); cube(); }");
    EXPECT_EQ(tree_of(flat), "prism");
    EXPECT_TRUE(contains(warnings_of(flat), "a solid among plane figures: left out"));
    const Scene solid = read("union() { group(); cube(); square(2); }");
    EXPECT_EQ(tree_of(solid), "box");
    EXPECT_TRUE(contains(warnings_of(solid), "a plane figure among solids: left out"));
}

TEST(Booleans, SettingsAreNoChildren) {
    EXPECT_EQ(tree("difference() { point_light(); cube(); sphere(); }"), "(box-ball)");
    EXPECT_EQ(tree("intersection() { film([9, 9]); cube(); sphere(); }"), "(box&ball)");
}

TEST(Booleans, ChildrenStandBeforeTheirParents) {
    const Scene scene = read("difference() { union() { cube(); sphere(); } intersection() { cube(); cylinder(); } }");
    for (std::uint32_t i = 0; i < scene.solids.nodes.size(); ++i) {
        const SolidNode& node = scene.solids.nodes[i];
        if (node.op == SolidOp::leaf) continue;
        for (std::uint32_t c = 0; c < node.count; ++c) EXPECT_LT(scene.solids.children[node.first + c], i);
    }
}

TEST(Booleans, WhatAnEmptyBooleanHeldIsNotKept) {
    const Scene scene = read("intersection() { sphere(1, $fn = 5); group(); } cylinder($fn = 5); cube();");
    EXPECT_EQ(scene.solids.leaves.size(), 2U);
    EXPECT_EQ(scene.solids.meshes.size(), 0U);
    EXPECT_EQ(tree_of(scene), "prism box");
}

TEST(Booleans, LeavesKnowTheirLine) {
    const Scene scene = read("group() {\n\tcube();\n\n\tsphere();\n}");
    EXPECT_EQ(scene.solids.leaves[0].line, 2U);
    EXPECT_EQ(scene.solids.leaves[1].line, 4U);
}

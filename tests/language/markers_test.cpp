#include <gtest/gtest.h>

#include "tests/language/read.hpp"

using namespace cardioid;
using cardioid::test::contains;
using cardioid::test::error_of;
using cardioid::test::read;
using cardioid::test::tree_of;

namespace {

/// As OpenSCAD evaluates a module that puts a marker.
std::string mark(const std::string& call) {
    return "group() {\n%\ttext(text = \"@cardioid " + call +
           "\", size = 0.001, spacing = 1, font = \"\", direction = \"ltr\", language = \"en\", script = \"Latn\", "
           "halign = \"left\", valign = \"baseline\", $fn = 0, $fa = 12, $fs = 2);\n}\n";
}

std::string names(const std::string& text) {
    const Scene scene =
        read("define_material(\"a\", kind = \"diffuse\"); define_material(\"b\", kind = \"dielectric\");" + text);
    std::string out;
    for (const Leaf& leaf : scene.solids.leaves)
        out.append(out.empty() ? "" : ", ").append(scene.materials.at(leaf.material).name);
    return out;
}

}  // namespace

TEST(Markers, AMaterialHoldsForItsSiblingsThatFollow) {
    EXPECT_EQ(
        names("cube(); group() { cube(); group() { " + mark("material('a')") + "} group() { sphere(); } } cube();"),
        "default, default, a, default");
}

TEST(Markers, AMaterialEndsAtItsEndMarker) {
    EXPECT_EQ(names(mark("material('a')") + "cube();" + mark("material('b')") + "cube();" + mark("end") + "cube();" +
                    mark("end") + "cube();"),
              "a, b, a, default");
    EXPECT_EQ(names(mark("end") + "cube();"), "default");
}

TEST(Markers, MaterialsOfInnerGroupsEndWithThem) {
    EXPECT_EQ(names(mark("material('a')") + "group() { cube(); " + mark("material('b')") + " cube(); } cube();"),
              "a, b, a");
}

TEST(Markers, AreIgnoredWhereChildrenAreCounted) {
    EXPECT_EQ(tree_of(read("difference() { " + mark("point_light()") + " cube(); sphere(); }")), "(box-ball)");
    EXPECT_EQ(tree_of(read("intersection() { group() { " + mark("film([9, 9])") + " } cube(); sphere(); }")),
              "(box&ball)");
}

TEST(Markers, LightsStandWhereTheTransformsPutThem) {
    const Scene scene = read("multmatrix([[1,0,0,7],[0,1,0,0],[0,0,1,0]]) { group() { " +
                             mark("area_light([2, 3], radiance = [1, 2, 3])") + " } }");
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(scene.lights[0].to_world.t.x, 7);
    EXPECT_EQ(scene.lights[0].params.colour("radiance", {}), Rgb(1, 2, 3));
}

TEST(Markers, MayBeSolids) {
    EXPECT_EQ(tree_of(read("difference() { cube(); translate([0, 0, 1]) " + mark("half_space([0, 0, 1], 0)") + "}")),
              "(box-half)");
}

TEST(Markers, DefineMaterialsAndCameras) {
    const Scene scene = read(mark("define_material('glass', kind = 'dielectric', ior = 1.4)") +
                             mark("camera([1, 2, 3], name = 'x')") + mark("photons(count = 5)") + "cube();");
    EXPECT_EQ(scene.materials.at(1).name, "glass");
    EXPECT_EQ(scene.cameras.at(0).name, "x");
    EXPECT_EQ(scene.photons.number("count", 0), 5);
}

TEST(Markers, SayTheirPlaceWhereTheyAreWrong) {
    EXPECT_TRUE(
        error_of("cube();\n%text(text = \"@cardioid materail('a')\");").starts_with("t.csg:2:1: no call \"materail\""));
    EXPECT_TRUE(error_of("\n%text(text = \"@cardioid material('a'\");").starts_with("t.csg:2:1: found"));
    EXPECT_TRUE(contains(error_of("%text(text = \"@cardioid difference()\");"), "not supported"));
}

TEST(Markers, OtherTextsAreNone) {
    EXPECT_EQ(tree_of(read("%text(text = \"hello\"); cube();")), "box");
    EXPECT_EQ(read("cube(); linear_extrude(1) text(text = \"@cardioid film([1, 1])\");").film.width, std::nullopt);
}

TEST(Markers, LongChainsOfGroupsTakeNoLongerThanTheyAre) {
    std::string text;
    for (int i = 0; i < 90'000; ++i) text += "group() ";
    EXPECT_EQ(read(text + mark("film([5, 6])")).film.width, 5);
}

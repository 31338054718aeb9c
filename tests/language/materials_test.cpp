#include <gtest/gtest.h>

#include "formats/openscad/evaluate/colours.hpp"
#include "tests/language/read.hpp"

using namespace cardioid;
using cardioid::test::contains;
using cardioid::test::error_of;
using cardioid::test::read;
using cardioid::test::warnings_of;

namespace {

/// The materials' names of all leaves, in document order.
std::string names(const std::string& text) {
    const Scene scene = read(
        "define_material(\"a\", kind = \"diffuse\"); define_material(\"b\", kind = \"dielectric\", ior = 1.3);" + text);
    std::string out;
    for (const Leaf& leaf : scene.solids.leaves)
        out.append(out.empty() ? "" : ", ").append(scene.materials.at(leaf.material).name);
    return out;
}

constexpr const char* red = "color [1, 0, 0, 1]";

}  // namespace

TEST(Materials, TheFirstIsTheDefault) {
    const Scene scene = read("cube();");
    EXPECT_EQ(scene.materials.at(0).name, "default");
    EXPECT_EQ(scene.materials[0].kind, "diffuse");
    EXPECT_EQ(scene.solids.leaves[0].material, 0U);
    EXPECT_EQ(read("define_material(\"default\", kind = \"dielectric\"); cube();").materials[0].kind, "dielectric");
}

TEST(Materials, TheInnerMaterialWins) {
    EXPECT_EQ(names("material(\"a\") { cube(); material(\"b\") cube(); cube(); } cube();"), "a, b, a, default");
}

TEST(Materials, OfColoursTheOutermostWins) {
    EXPECT_EQ(names("color(\"red\") color(\"blue\") cube();"), red);
    EXPECT_EQ(names("color([-1, -1, -1, 0.5]) color([1, 0, 0]) color(\"nonsense\") cube();"), red);
    EXPECT_EQ(names("color(undef, 0.5) color(\"red\") cube();"), red);
}

TEST(Materials, OfMaterialAndColourTheNearestWins) {
    EXPECT_EQ(names("color(\"red\") material(\"a\") cube();"), "a");
    EXPECT_EQ(names("material(\"a\") color(\"red\") color(\"blue\") cube();"), red);
}

TEST(Materials, WhatCutsTakesTheMaterialOfWhatIsCutWhereItHasNone) {
    EXPECT_EQ(names("difference() { color(\"red\") cube(); sphere(); material(\"b\") sphere(); }"),
              std::string(red) + ", " + red + ", b");
    EXPECT_EQ(names("material(\"a\") difference() { color(\"red\") cube(); sphere(); }"), std::string(red) + ", a");
    EXPECT_EQ(names("difference() { material(\"a\") cube(); difference() { sphere(); cube(); } }"), "a, a, a");
    EXPECT_EQ(names("intersection() { material(\"a\") cube(); sphere(); }"), "a, default");
}

TEST(Materials, MayBeUsedBeforeTheyAreDefined) {
    const Scene scene = read("material(\"late\") cube(); define_material(\"late\", kind = \"dielectric\", ior = 1.7);");
    EXPECT_EQ(scene.materials.at(scene.solids.leaves[0].material).params.number("ior", 0), 1.7);
    EXPECT_EQ(error_of("define_material(\"steel\", kind = \"diffuse\"); group() material(\"stele\") cube();"),
              "t.csg:1:53: no material \"stele\" (did you mean \"steel\"?)");
}

TEST(Materials, UnknownKindsAreErrorsAndUnknownParametersWarnings) {
    EXPECT_EQ(error_of("define_material(\"x\", kind = \"difuse\"); cube();"),
              "t.csg:1:1: no material kind \"difuse\" (did you mean \"diffuse\"?)");
    EXPECT_TRUE(
        contains(error_of("define_material(\"m\", kind = \"glass\");"), ", wanted diffuse, filter, dielectric"));
    EXPECT_TRUE(contains(error_of("define_material(\"x\"); cube();"), "has no kind"));
    EXPECT_TRUE(contains(error_of("define_material(kind = \"diffuse\"); cube();"), "name of define_material()"));
    const Scene scene = read("define_material(\"x\", kind = \"diffuse\", reflectanse = 0.3, emission = 1); cube();");
    EXPECT_EQ(warnings_of(scene),
              "t.csg:1:1: material kind \"diffuse\" has no parameter \"reflectanse\" (did you mean \"reflectance\"?): "
              "ignored\n");
    EXPECT_EQ(read("define_material(\"x\", kind = \"plugin:diffuse\"); cube();").materials[1].kind, "diffuse");
}

TEST(Materials, ColoursAreDisplayValuesMadeLinear) {
    const Scene scene = read("color([0.5, 1, 0]) cube();");
    const MaterialSettings& material = scene.materials.at(scene.solids.leaves[0].material);
    EXPECT_EQ(material.kind, "diffuse");
    const Rgb c = material.params.colour("reflectance", {});
    EXPECT_NEAR(c.r, 0.214041, 1e-6);  // ((0.5 + 0.055) / 1.055)^2.4
    EXPECT_EQ(c.g, 1);
    EXPECT_EQ(c.b, 0);
}

TEST(Materials, ATransparentColourIsAFilter) {
    const Scene scene = read("color(\"red\", alpha = 0.25) cube(); color([1, 0, 0, 0.25]) cube();");
    const MaterialSettings& material = scene.materials.at(scene.solids.leaves[0].material);
    EXPECT_EQ(material.kind, "filter");
    EXPECT_EQ(material.params.number("transmittance", 0), 0.75);
    EXPECT_EQ(scene.solids.leaves[1].material, scene.solids.leaves[0].material) << "one colour, one material";
}

TEST(Materials, ColoursAreClampedAndMustBeFinite) {
    EXPECT_EQ(names("color([7, -0.5, 0]) cube();"), red);
    EXPECT_TRUE(contains(error_of("color([nan, 0, 0]) cube();"), "not finite"));
}

TEST(Materials, ColourNamesAndHexadecimalsAsOpenscadHasThem) {
    using formats::openscad::parse_colour;
    EXPECT_EQ(parse_colour("Red"), (formats::openscad::Rgba{1, 0, 0, 1}));
    EXPECT_EQ(parse_colour("#f00"), parse_colour("red"));
    EXPECT_EQ(parse_colour("#FF000080")->at(3), 128 / 255.0);
    EXPECT_EQ(parse_colour("#f008")->at(3), 136 / 255.0);
    EXPECT_EQ(parse_colour("DarkOliveGreen")->at(0), 85 / 255.0);
    EXPECT_FALSE(parse_colour("#12345"));
    EXPECT_FALSE(parse_colour("#ggg"));
    EXPECT_FALSE(parse_colour(""));
    EXPECT_TRUE(contains(warnings_of(read("color(\"oragne\") cube();")), "(did you mean \"orange\"?)"));
}

TEST(Materials, MapColorTurnsAColourIntoAMaterial) {
    EXPECT_EQ(names("color([1, 0, 0]) cube(); color(\"blue\") cube(); map_color([1, 0, 0, 1], \"b\");"),
              "b, color [0, 0, 1, 1]");
    EXPECT_EQ(names("map_color([0.501961, 0, 0, 1], \"b\"); color(\"#800000\") cube();"), "b") << "6 digits count";
    EXPECT_TRUE(contains(error_of("map_color([1, 0, 0, 1], \"no\"); cube();"), "no material \"no\""));
}

TEST(Materials, AColourThatNothingHasIsToldWithTheNearestOnesThereAre) {
    const Scene scene = read(
        "color([1, 0, 0]) cube(); color([0, 0.5, 0]) cube();\n"
        "define_material(\"b\", kind = \"diffuse\"); map_color([0, 0.498, 0, 1], \"b\");");
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_TRUE(contains(scene.warnings[0],
                         "nothing has the colour [0, 0.498, 0, 1]; the model has [0, 0.5, 0, 1], "
                         "[1, 0, 0, 1]"))
        << scene.warnings[0];
}

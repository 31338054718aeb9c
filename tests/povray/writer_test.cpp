/// What the writer says, without POV-Ray.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/openscad/openscad_format.hpp"
#include "formats/povray/povray_format.hpp"
#include "tests/povray/twin.hpp"

namespace cardioid::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* view = "camera([0, -100, 0], look_at = [0, 0, 0], fov = 90);\n";

struct Written {
    std::string text;
    std::vector<std::string> notes;
};

Written write(const std::string& csg, WriteOptions options = {}) {
    ReadOptions read;
    read.registry = &registry();
    const Scene scene = formats::csg_format.read(view + csg, "room.csg", read);
    Written out;
    options.notes = &out.notes;
    out.text = formats::pov_format.write(scene, options);
    return out;
}

TEST(PovWriter, PutsTheCameraAsVectors) {
    EXPECT_THAT(
        write("sphere(10);").text,
        HasSubstr("perspective location <0, -100, 0> direction <0, 1, 0> right <1, 0, 0>*2*Aspect up <0, 0, 1>*2"));
}

TEST(PovWriter, KeepsShapesThatAreThere) {
    const std::string text = write(
                                 "translate([1, 2, 3]) sphere(10); translate([5, 0, 0]) cube([1, 2, 3]);"
                                 "cylinder(h = 4, r = 2); cylinder(h = 4, r1 = 2, r2 = 1);"
                                 "half_space([0, 0, 1], -7);")
                                 .text;
    EXPECT_THAT(text, HasSubstr("sphere { <1, 2, 3>, 10 "));
    EXPECT_THAT(text, HasSubstr("box { <5, 0, 0>, <6, 2, 3> "));
    EXPECT_THAT(text, HasSubstr("cylinder { <0, 0, 0>, <0, 0, 4>, 2 "));
    EXPECT_THAT(text, HasSubstr("cone { <0, 0, 0>, 2, <0, 0, 4>, 1 "));
    EXPECT_THAT(text, HasSubstr("plane { <0, 0, 1>, -7 "));
}

TEST(PovWriter, KeepsBooleansAndTheMaterialOfEachPart) {
    const std::string text = write(
                                 "define_material(\"red\", kind = \"diffuse\", reflectance = [0.5, 0, 0]);\n"
                                 "define_material(\"blue\", kind = \"diffuse\", reflectance = [0, 0, 0.5]);\n"
                                 "material(\"red\") difference() { cube(10); sphere(4); }\n"
                                 "difference() { material(\"red\") cube(9); material(\"blue\") sphere(3); }\n")
                                 .text;
    EXPECT_THAT(text, HasSubstr("#declare M_red = texture { pigment { rgb <0.5, 0, 0> } finish { diffuse 1 } }"));
    // Of one material: said once, behind the parts.
    EXPECT_THAT(text, HasSubstr("sphere { <0, 0, 0>, 4 }  // 4\ntexture { M_red } }"));
    EXPECT_THAT(text, HasSubstr("sphere { <0, 0, 0>, 3 texture { M_blue } }  // 5"));
}

TEST(PovWriter, MakesAUnionOfGlassAMerge) {
    const char* glass =
        "define_material(\"glass\", kind = \"dielectric\", straight_shadows = true);\n"
        "material(\"glass\") union() { sphere(4); translate([3, 0, 0]) sphere(4); }";
    EXPECT_THAT(write(glass).text, HasSubstr("merge {"));
    EXPECT_THAT(write("difference() { union() { sphere(4); translate([3, 0, 0]) sphere(4); } cube(1); }").text,
                HasSubstr("union {"));
}

TEST(PovWriter, GivesGlassABlackShadowUnlessItIsStraightOrPhotonsGoThrough) {
    const std::string glass = "define_material(\"glass\", kind = \"dielectric\");\nmaterial(\"glass\") sphere(4);";
    EXPECT_THAT(write(glass).text, HasSubstr("no_image no_reflection"));
    EXPECT_THAT(write(glass, {.photons = true}).text, HasSubstr("photons { target reflection on refraction on }"));
    EXPECT_THAT(write(glass, {.photons = true}).text, Not(HasSubstr("no_image")));
    EXPECT_THAT(
        write("define_material(\"g\", kind = \"dielectric\", straight_shadows = true);\nmaterial(\"g\") sphere(4);")
            .text,
        Not(HasSubstr("no_shadow")));
}

TEST(PovWriter, GrowsACutterWhereItsFaceCoincidesAndNowhereElse) {
    const std::string flush =
        write("difference() { cube([100, 100, 10]); translate([20, 20, 0]) cube([5, 5, 10]); }").text;
    EXPECT_THAT(flush, HasSubstr("box { <0, 0, 0>, <100, 100, 10> }"));
    EXPECT_THAT(flush, HasSubstr("box { <20, 20, -0.000"));
    const std::string clear =
        write("difference() { cube([100, 100, 10]); translate([20, 20, -1]) cube([5, 5, 12]); }").text;
    EXPECT_THAT(clear, HasSubstr("box { <20, 20, -1>, <25, 25, 11> }"));
}

TEST(PovWriter, ScalesWhatIsTooSmallOrTooLargeForPovRay) {
    ReadOptions read;
    read.registry = &registry();
    const Scene tiny = formats::csg_format.read(
        "camera([0, -0.1, 0], look_at = [0, 0, 0]); point_light(intensity = 2); sphere(0.01);", "tiny.csg", read);
    const std::string text = formats::pov_format.write(tiny, {});
    EXPECT_THAT(text, HasSubstr("// 1000 units here are 1 of the scene"));
    EXPECT_THAT(text, HasSubstr("sphere { <0, 0, 0>, 10 "));
    // Intensity goes with the square of lengths: 2 * 1e6 / pi / (2 * 1e-6).
    EXPECT_THAT(text, HasSubstr("color rgb 3.1830"));
}

TEST(PovWriter, NotesWhatPovRayCannotSayByNameAndLine) {
    const Written written = write(
        "define_material(\"coat\", kind = \"plastic\");\nmaterial(\"coat\") sphere(4);\n"
        "sky(file = \"harbour.exr\");\n");
    EXPECT_THAT(written.notes, ::testing::Contains(HasSubstr("room.csg:2:1: material \"coat\" (plastic)")));
    EXPECT_THAT(written.notes, ::testing::Contains(HasSubstr("room.csg:4:1: sky: a picture of the sky is left out")));
    for (const std::string& note : written.notes) EXPECT_THAT(written.text, HasSubstr("//   " + note));
    EXPECT_TRUE(write("sphere(4); translate([0, 0, 50]) point_light();").notes.empty());
}

TEST(PovWriter, LeavesOutWhatMakesNothing) {
    const std::string text =
        write("difference() { intersection() { } sphere(3); } union() { sphere(2); union() { } }").text;
    EXPECT_THAT(text, Not(HasSubstr("difference")));
    EXPECT_THAT(text, Not(HasSubstr("union")));
    EXPECT_THAT(text, HasSubstr("sphere { <0, 0, 0>, 2 "));
}

TEST(PovWriter, WritesALampAsPointsOrAsOne) {
    const std::string lamp = "translate([0, 0, 50]) area_light([10, 10], radiance = 1, grid = 3);";
    const auto count = [](const std::string& text) {
        std::size_t n = 0;
        for (std::size_t at = 0; (at = text.find("light_source", at)) != std::string::npos; ++at) ++n;
        return n;
    };
    EXPECT_EQ(count(write(lamp).text), 9U);
    const std::string one = write(lamp, {.light_arrays = true, .light_grid = 5}).text;
    EXPECT_EQ(count(one), 1U);
    EXPECT_THAT(one, HasSubstr("3, 3 area_illumination on"));
    EXPECT_THAT(write("area_light([10, 10]);", {.light_arrays = true, .light_grid = 5}).text,
                HasSubstr("area_light <8, 0, 0>, <0, 8, 0>, 5, 5 area_illumination on"));
}

}  // namespace
}  // namespace cardioid::test

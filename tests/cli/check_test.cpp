#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

namespace cardioid::test {
namespace {

using Json = nlohmann::json;

struct Faulty {
    std::string scene, kind, text;
};
TEST(Check, FindsEachFaultAndEndsWithOne) {
    const Folder folder;
    for (const Faulty& faulty : std::vector<Faulty>{
             Faulty{"cube(2);\nmultmatrix([[1,0,0,1],[0,1,0,1],[0,0,1,1]]) sphere(1);", "overlap",
                    "a.csg:1 (box, material \"default\") and a.csg:2 (sphere, material \"default\") overlap at"},
             Faulty{"union() { color([1, 0, 0]) cube(2); color([0, 1, 0]) sphere(1); }", "overlap", "overlap at"},
             Faulty{"half_space([0,0,1], 0);\ncube(1, center = true);", "overlap", "overlap at"},
             Faulty{"polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = [[0,1,2],[0,3,1],[0,2,3]]);",
                    "open_mesh", "the mesh is not closed: 3 open edges, the first at ("},
             Faulty{"point_light(intensity = 0); cube(1);", "unlit",
                    "a.csg: the scene is unlit: its lights have no power"},
             Faulty{"sun([0,0,-1]); camera([1,1,1], look_at = [5,0,0], name = \"in\"); cube(2);", "camera",
                    "camera \"in\" at (1, 1, 1) is inside a solid"},
             Faulty{"sun([0,0,-1]); camera([50,0,0], look_at = [90,0,0]); cube(2);", "camera",
                    "camera \"main\" at (50, 0, 0) sees nothing: it looks past the model"},
             Faulty{"sun([0,0,-1]); camera([1,1,1], look_at = [5,1,1]);"
                    "difference() { cube(9, center = true); cube(8, center = true); }",
                    "camera", "camera \"main\" at (1, 1, 1) sees no light"},
             Faulty{"difference() { cube(10); multmatrix([[1,0,0,-1],[0,1,0,-1],[0,0,1,-1]]) cube([12,12,10.99995]); }",
                    "thin_solid", "leave a skin 5e-05 thick between them at ("},
             Faulty{"cube(10); multmatrix([[1,0,0,10.0001],[0,1,0,0],[0,0,1,0]]) cube(10);", "thin_gap",
                    "leave a gap 0.0001 wide between them at (10, "},
             Faulty{"color([-1, -1, -1, 1]) cube(2);", "colour", "a.csg:1: found color([-1, -1, -1, 1])"},
             Faulty{"color(\"redd\") cube(2);", "colour", "no colour \"redd\" (did you mean \"red\"?)"},
             Faulty{"cube([1, 0, 1]);", "reader", "a.csg:1:1: "},
             Faulty{"frobnicate() cube(1);", "reader", "frobnicate"}}) {
        folder.write("a.csg", faulty.scene);
        const Outcome run = folder.call({"check", "a.csg", "--json", "a.json"});
        EXPECT_EQ(run.status, 1) << run.out << run.err;
        EXPECT_NE(run.out.find(faulty.text), std::string::npos) << run.out;
        EXPECT_NE(run.out.find("a.csg: 1 fault\n"), std::string::npos) << run.out;
        const Json json = Json::parse(folder.read("a.json"));
        ASSERT_EQ(json["faults"].size(), 1U) << json;
        EXPECT_EQ(json["faults"][0]["kind"], faulty.kind);
    }
}

TEST(Check, NotesSolidsInNoCombinationWithoutCallingThemAFault) {
    const Folder folder;
    folder.write("m.asc",
                 "title {spare}\nunits mm\nput {ball.s} ell V {0 0 0} A {2 0 0} B {0 2 0} C {0 0 2}\n"
                 "put {spare.s} ell V {9 0 0} A {2 0 0} B {0 2 0} C {0 0 2}\n"
                 "put {ball.r} comb region yes tree {l {ball.s}}\n");
    const Outcome run = folder.call({"check", "m.asc"});
    EXPECT_EQ(run.status, 0) << run.out << run.err;
    EXPECT_NE(run.out.find("note: m.asc: in no combination and left out; name them to draw them: spare.s"),
              std::string::npos)
        << run.out;
}

TEST(Check, FindsNothingInSoundScenes) {
    const Folder folder;
    for (const char* const scene :
         {"union() { cube(2); sphere(1); } translate([5, 0, 0]) { cube(2); sphere(1); }",
          "define_material(\"w\", kind = \"dielectric\"); material(\"w\") cube(2); cube(1);", "cube(1);",
          "cube(1); translate([1, 0, 0]) cube(1); translate([0, 0, 1]) cube([2, 1, 3]);",
          "define_material(\"fog\", kind = \"dielectric\", ior = 1); camera([0,-3,0], look_at = [0,0,0]);"
          "difference() { cube(10, center = true); cube(8, center = true); } material(\"fog\") cube(8, center = true);"
          "point_light(intensity = 1);",
          "half_space([0,0,1], 0); translate([0,0,2]) sphere(2);",
          "difference() { cube(4, center = true); sphere(2); } sphere(1);",
          "define_material(\"g\", kind = \"dielectric\"); sun([0,0,-1]);"
          "camera([1,1,1], look_at = [5,0,0]); material(\"g\") cube(2);",
          "define_material(\"e\", kind = \"emitter\", emission = [1,1,1]); camera([9,9,9], look_at = "
          "[0,0,0]); material(\"e\") cube(1);",
          "group();"}) {
        folder.write("a.csg", scene);
        const Outcome run = folder.call({"check", "a.csg"});
        EXPECT_EQ(run.status, 0) << run.out << run.err;
        EXPECT_NE(run.out.find("a.csg: no faults\n"), std::string::npos) << run.out;
    }
}

TEST(CheckReport, OverlapsHaveTheirPlaceDepthAndSolids) {
    const Folder folder;
    folder.write("a.csg", "cube(4);\nmultmatrix([[1,0,0,3],[0,1,0,1],[0,0,1,1]]) cube(2);");
    const Outcome run = folder.call({"check", "a.csg", "--json", "-"});
    EXPECT_EQ(run.status, 1);
    const Json fault = Json::parse(run.out)["faults"][0];
    EXPECT_NEAR(fault["depth"], 2, 0.01);  // along y and z; it is 1 along x
    EXPECT_NEAR(fault["volume"], 4, 0.2);
    EXPECT_NEAR(fault["at"][0], 3.5, 0.51);
    EXPECT_EQ(fault["between"].size(), 2U);
    EXPECT_EQ(fault["between"][1], "a.csg:2 (box, material \"default\")");
}

TEST(CheckReport, SolidsOfAnOpenScadFileAreOneUnion) {
    const Folder folder;
    const std::string solids = "cube(size = [4, 4, 4], center = false);\n";
    folder.write("a.csg", solids + "color([1, 0, 0, 1]) cube(size = [2, 2, 2], center = false);");
    const Outcome meant = folder.call({"check", "a.csg"});
    EXPECT_EQ(meant.status, 0) << meant.out;
    EXPECT_NE(meant.out.find("note: a.csg:1 (box, material \"default\") and a.csg:2"), std::string::npos) << meant.out;
    EXPECT_EQ(folder.call({"check", "a.csg", "--strict"}).status, 1);
}

TEST(CheckReport, CoincidentFacesAreNotedWithTheirPlace) {
    const Folder folder;
    folder.write("a.csg", "difference() { cube(10); multmatrix([[1,0,0,2],[0,1,0,2],[0,0,1,0]]) cube([3,3,20]); }");
    const Outcome run = folder.call({"check", "a.csg", "--json", "-"});
    EXPECT_EQ(run.status, 0) << run.out;
    Json coincident;
    const Json json = Json::parse(run.out);
    for (const Json& note : json["notes"])
        if (note["kind"] == "coincident") coincident = note;
    ASSERT_TRUE(coincident.is_object()) << run.out;
    EXPECT_NEAR(coincident["at"][2], 0, 1e-12);
    EXPECT_EQ(coincident["depth"], 0);
    EXPECT_EQ(json["grids"]["faces_lines_an_axis"][0], 128);
    EXPECT_EQ(folder.call({"check", "a.csg", "--strict"}).status, 1);
}

TEST(CheckReport, TheSceneIsNotOverwrittenByItsReport) {
    const Folder folder;
    folder.write("a.csg", "cube(1);");
    EXPECT_EQ(folder.call({"check", "a.csg", "--json", "a.csg"}).status, 2);
    EXPECT_EQ(folder.read("a.csg"), "cube(1);");
}

TEST(CheckReport, AnUnknownMaterialNamesTheNearest) {
    const Folder folder;
    folder.write("a.csg", "define_material(\"steel\", kind = \"diffuse\");\nmaterial(\"stel\") cube(1);");
    const Outcome run = folder.call({"check", "a.csg"});
    EXPECT_NE(run.status, 0);
    EXPECT_NE((run.out + run.err).find("a.csg:2:"), std::string::npos) << run.out << run.err;
    EXPECT_NE((run.out + run.err).find("(did you mean \"steel\"?)"), std::string::npos) << run.out << run.err;
}

TEST(CheckReport, AModelWithoutLightIsANoteAndNoFault) {
    const Folder folder;
    folder.write("a.csg", "cube(1);");
    const Outcome run = folder.call({"check", "a.csg", "--json", "-"});
    EXPECT_EQ(run.status, 0);
    const Json json = Json::parse(run.out);
    EXPECT_TRUE(json["faults"].empty());
    EXPECT_EQ(json["notes"].size(), 1U);
    EXPECT_EQ(json["notes"][0]["kind"], "unlit");
}

}  // namespace
}  // namespace cardioid::test

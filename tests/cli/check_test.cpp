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

TEST(Check, FindsNothingInSoundScenes) {
    const Folder folder;
    for (const char* const scene :
         {"union() { cube(2); sphere(1); } translate([5, 0, 0]) { cube(2); sphere(1); }",
          "define_material(\"w\", kind = \"dielectric\"); material(\"w\") cube(2); cube(1);", "cube(1);",
          "cube(1); translate([1, 0, 0]) cube(1); translate([0, 0, 1]) cube([2, 1, 3]);",
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
}

}  // namespace
}  // namespace cardioid::test

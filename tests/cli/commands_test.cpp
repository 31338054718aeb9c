#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/cli/program.hpp"

namespace cardioid::test {
namespace {

using Json = nlohmann::json;

TEST(List, NamesWhatIsBuiltInWithItsParameters) {
    const Folder folder;
    const std::vector<std::pair<std::string, std::vector<std::string>>> wanted{
        {"shaders", {"diffuse: ", "phong: ", "dielectric: ", "reflectance", "ior", "1.5"}},
        {"lights", {"point_light: ", "sun: ", "sky: ", "area_light: ", "intensity"}},
        {"lighting", {"direct: "}},
        {"formats", {".csg", "read, write", ".scad"}},
        {"options", {}}};
    for (const auto& [subject, parts] : wanted) {
        const Outcome run = folder.call({"list", subject});
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_FALSE(run.out.empty());
        for (const std::string& part : parts) EXPECT_NE(run.out.find(part), std::string::npos) << run.out;
    }
}

TEST(Convert, WritesASceneThatReadsAsTheSame) {
    const Folder folder;
    folder.write("a.csg",
                 "define_material(\"m\", kind = \"diffuse\", reflectance = [0.1, 0.2, 0.3]);\n"
                 "material(\"m\") difference() { cube(4); sphere(1, $fn = 6); }\n"
                 "camera([9, 8, 7], look_at = [0, 0, 1]); sun([0, 0, -1]);");
    EXPECT_EQ(folder.call({"convert", "a.csg", "-o", "b.csg"}).status, 0);
    EXPECT_EQ(folder.call({"convert", "b.csg", "-o", "c.csg"}).status, 0);
    EXPECT_EQ(folder.read("b.csg"), folder.read("c.csg"));
    EXPECT_EQ(folder.cardioid({"convert", "-", "-o", "-"}, {.input = folder.read("a.csg")}).out, folder.read("b.csg"));
    for (const char* const name : {"a", "b"})
        EXPECT_EQ(folder.call({name + std::string(".csg"), "-s", "16", "--spp", "4", "-q"}).status, 0);
    const Json a = Json::parse(folder.call({"info", "a.csg", "--json", "-"}).out);
    const Json b = Json::parse(folder.call({"info", "b.csg", "--json", "-"}).out);
    for (const char* const key : {"leaves", "bounds", "volume", "cameras", "lights"}) EXPECT_EQ(a[key], b[key]) << key;
}

TEST(Convert, WarnsUnlessQuiet) {
    const Folder folder;
    folder.write("a.csg", "cube(1); sphere(0);");
    EXPECT_NE(folder.call({"convert", "a.csg", "-o", "b.csg"}).err.find("cardioid: warning: a.csg:1:10: "),
              std::string::npos);
    const Outcome quiet = folder.call({"convert", "a.csg", "-o", "c.csg", "-q"});
    EXPECT_EQ(quiet.status, 0);
    EXPECT_EQ(quiet.err, "");
    EXPECT_EQ(folder.read("b.csg"), folder.read("c.csg"));
}

TEST(Info, MeasuresTheVolumeWithinFourStandardErrors) {
    const Folder folder;
    folder.write("a.csg", "difference() { cube(4, center = true); sphere(2); }");
    const Json json = Json::parse(folder.call({"info", "a.csg", "--json", "-"}).out);
    const double exact = 64 - 4.0 / 3 * std::numbers::pi * 8, sigma = json["volume_standard_error"];
    EXPECT_GT(sigma, 0);
    EXPECT_LT(sigma, 2e-3 * exact);
    EXPECT_NEAR(json["volume"].get<double>(), exact, 4 * sigma);
    EXPECT_GT(std::abs(json["volume"].get<double>() - 1.02 * exact), 4 * sigma);
    EXPECT_EQ(json["leaves"], (Json{{"box", 1}, {"sphere", 1}}));
    EXPECT_EQ(json["solids"], 1);
}

TEST(Info, SaysWhereThereIsNoBoundAndWhereThereIsNothing) {
    const Folder folder;
    folder.write("plane.csg", "half_space([0, 0, 1], 0);");
    folder.write("empty.csg", "group();");
    EXPECT_NE(folder.call({"info", "plane.csg"}).out.find("volume: unbounded"), std::string::npos);
    EXPECT_TRUE(Json::parse(folder.call({"info", "plane.csg", "--json", "-"}).out)["volume"].is_null());
    EXPECT_NE(folder.call({"info", "empty.csg"}).out.find("volume: 0 +- 0"), std::string::npos);
}

TEST(Info, FallsBackToRaysWhereThereIsNoMeshAndSaysWhy) {
    const Folder folder;
    folder.write("a.csg",
                 "polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = [[0,1,2],[0,3,1],[0,2,3]]);\n"
                 "cube(0.5);");
    const Outcome run = folder.call({"info", "a.csg", "--volume", "--json", "a.json"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("exact mesh: none, volume and area are those by rays: a.csg: a boolean of meshes failed: a "
                           "mesh is not closed"),
              std::string::npos)
        << run.out;
    const Json json = Json::parse(folder.read("a.json"));
    EXPECT_GT(json["volume_standard_error"], 0);
    EXPECT_GT(json["area_standard_error"], 0);
    EXPECT_FALSE(json.contains("mesh_volume"));
    EXPECT_NE(json["mesh_refused"].get<std::string>().find("not closed"), std::string::npos);
}

TEST(Info, TellsWhatMadeAPicture) {
    const Folder folder;
    folder.write("a.csg", "cube(1);");
    for (const std::string name : {"a.png", "a.exr", "a.jpg"}) {
        EXPECT_EQ(folder.call({"a.csg", "-s", "12x8", "--spp", "3", "--seed", "7", "-q", "-o", name}).status, 0);
        const Json json = Json::parse(folder.call({"info", name, "--json", "-"}).out);
        EXPECT_EQ(json["width"], 12);
        EXPECT_EQ(json["height"], 8);
        const Json& made = json["metadata"];
        EXPECT_EQ(made["Software"].get<std::string>().find("Cardioid 0."), 0U);
        EXPECT_EQ(made["CommandLine"], "cardioid render a.csg -s 12x8 --spp 3 --seed 7");
        EXPECT_EQ(made["Seed"], "7");
        EXPECT_EQ(made["Samples"], "3");
        EXPECT_EQ(made["SceneHash"].get<std::string>().size(), 16U);
        const std::string text = folder.call({"info", name}).out;
        EXPECT_NE(text.find("size: 12x8"), std::string::npos);
        EXPECT_NE(text.find("Software: Cardioid"), std::string::npos);
    }
}

}  // namespace
}  // namespace cardioid::test

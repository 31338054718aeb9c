#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include "formats/openscad/openscad_format.hpp"
#include "tests/language/read.hpp"

using namespace cardioid;
using cardioid::test::contains;
namespace fs = std::filesystem;

namespace {

class Scad : public ::testing::Test {
protected:
    void SetUp() override {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string write(const char* name, const std::string& text) {
        std::ofstream(folder_ / name) << text;
        return (folder_ / name).string();
    }
    static Scene read(const std::string& text, const std::string& file) {
        ReadOptions options;
        options.registry = &test::small_registry();
        return formats::scad_format.read(text, file, options);
    }
    static bool has_openscad() { return std::system("command -v openscad >/dev/null 2>&1") == 0; }

    fs::path folder_ =  // the space must not matter
        fs::temp_directory_path() / ("cardioid language scad " + std::to_string(::getpid()));
};

}  // namespace

TEST_F(Scad, ProgramsAreEvaluatedByOpenscad) {
    if (!has_openscad()) GTEST_SKIP() << "openscad is not installed";
    const std::string file = write("p.scad", "for (i = [0:2]) translate([2 * i, 0, 0]) cube(1); sphere(r = 1 / 3);");
    const Scene scene = read("", file);
    EXPECT_EQ(test::tree_of(scene), "box box box ball");
    EXPECT_TRUE(scene.six_digits);
    EXPECT_EQ(scene.file, file);
    EXPECT_EQ(fs::path(scene.base_dir), folder_);
}

TEST_F(Scad, ImportsAreLookedForBesideTheProgram) {
    if (!has_openscad()) GTEST_SKIP() << "openscad is not installed";
    write("t.stl",
          "solid t\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
          "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
          "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n"
          "facet normal 0 0 0\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid t\n");
    EXPECT_EQ(test::tree_of(read("", write("p.scad", "import(\"t.stl\");"))), "mesh");
}

TEST_F(Scad, OpenscadsRefusalIsTheMessage) {
    if (!has_openscad()) GTEST_SKIP() << "openscad is not installed";
    try {
        read("", write("p.scad", "cube(1;"));
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::bad_input);
        EXPECT_TRUE(contains(e.what(), "ERROR: Parser error")) << e.what();
    }
}

TEST_F(Scad, AProgramThatMakesNothingIsToldAsSuch) {
    if (!has_openscad()) GTEST_SKIP() << "openscad is not installed";
    const std::string file = write("p.scad", "echo(1);");
    try {
        read("", file);
        ADD_FAILURE() << "read";
    } catch (const Error& e) {
        EXPECT_EQ(e.what(), file + ": openscad finds no model in it");
    }
}

TEST_F(Scad, OpenscadsWarningsAreTheScenes) {
    if (!has_openscad()) GTEST_SKIP() << "openscad is not installed";
    EXPECT_TRUE(contains(test::warnings_of(read("", write("p.scad", "nothing_known(); cube(1);"))),
                         "Ignoring unknown module 'nothing_known'"));
}

TEST_F(Scad, OurLibraryCarriesEveryCallThroughOpenscad) {
    if (!has_openscad()) GTEST_SKIP() << "openscad is not installed";
    const Scene scene =
        read("", write("p.scad", std::string("use <") + CARDIOID_SOURCE_DIR +
                                     "/share/cardioid.scad>\n"
                                     "film([64, 48], samples = 4); camera([1, 2, 3.5], fov = 30);\n"
                                     "define_material(\"g\", kind = \"dielectric\", ior = 1.4);\n"
                                     "translate([0, 0, 9]) area_light([1, 2], radiance = [1, 2, 3]);\n"
                                     "photons(count = 1000); map_color([1, 0, 0, 1], \"g\");\n"
                                     "difference() { material(\"g\") { cube(3); sphere(2); }\n"
                                     "half_space([0, 0, 1], 0.5); } cube(1); color(\"red\") torus(9, 1);\n"
                                     "material(\"g\") ellipsoid([1, 2, 3]); cube(2);"));
    EXPECT_EQ(test::warnings_of(scene), "");
    EXPECT_EQ(test::tree_of(scene), "((box+ball)-half) box torus ball box");
    std::string materials;
    for (const Leaf& leaf : scene.solids.leaves) materials += scene.materials.at(leaf.material).name + " ";
    EXPECT_EQ(materials, "g g g default g g default ");
    EXPECT_EQ(scene.film.width, 64);
    EXPECT_EQ(scene.cameras.at(0).eye, Vec3d(1, 2, 3.5));
    EXPECT_EQ(scene.lights.at(0).to_world.t.z, 9);
    EXPECT_EQ(scene.lights[0].params.colour("radiance", {}), Rgb(1, 2, 3));
    EXPECT_EQ(scene.photons.number("count", 0), 1000);
}

TEST_F(Scad, StandardInputIsEvaluatedToo) {
    if (!has_openscad()) GTEST_SKIP() << "openscad is not installed";
    EXPECT_EQ(test::tree_of(read("cube(1 + 1);", "-")), "box");
}

TEST_F(Scad, WithoutOpenscadTheMessageSaysWhatToDo) {
    const std::string path = getenv("PATH");
    ASSERT_EQ(setenv("PATH", folder_.c_str(), 1), 0);
    try {
        read("", write("p.scad", "cube(1);"));
        ADD_FAILURE();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::io);
        EXPECT_TRUE(contains(e.what(), "apt install openscad")) << e.what();
    }
    setenv("PATH", path.c_str(), 1);
}

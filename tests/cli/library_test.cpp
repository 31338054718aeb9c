#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

// cardioid.scad is found by OpenSCAD wherever the program is installed.
namespace cardioid::test {
namespace {

namespace fs = std::filesystem;

class Library : public ::testing::Test {
protected:
    void SetUp() override {
        if (std::system("command -v openscad >/dev/null 2>&1") != 0) GTEST_SKIP() << "openscad is not installed";
    }
    /// A tree as `cmake --install` makes it.
    void install() const {
        fs::create_directories(folder_.path("usr/bin"));
        fs::create_directories(folder_.path("usr/share/cardioid"));
        fs::copy_file(CARDIOID_PROGRAM, folder_.path("usr/bin/cardioid"));
        fs::copy_file(CARDIOID_SOURCE_DIR "/share/cardioid.scad", folder_.path("usr/share/cardioid/cardioid.scad"));
    }
    const Folder folder_;
};

TEST_F(Library, IsFoundFromAnInstalledTree) {
    install();
    folder_.write("m.scad",
                  "use <cardioid.scad>\n"
                  "define_material(\"glass\", kind = \"dielectric\");\n"
                  "translate([0, 0, 50]) sphere_light(2, power = 100);\n"
                  "material(\"glass\") sphere(5);\n");
    const Outcome run = folder_.shell("usr/bin/cardioid info m.scad --json -");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("\"name\": \"glass\""), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("\"sphere_light\""), std::string::npos) << run.out;
}

TEST_F(Library, OnesOwnFoldersOfLibrariesAreSearchedToo) {
    install();
    fs::create_directories(folder_.path("mine"));
    folder_.write("mine/part.scad", "module part() { cube([1, 2, 3]); }");
    folder_.write("m.scad", "use <part.scad>\nuse <cardioid.scad>\nmaterial(\"default\") part();\n");
    const Outcome run = folder_.shell("OPENSCADPATH=$PWD/mine usr/bin/cardioid info m.scad");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("bounds: 0 0 0 to 1 2 3"), std::string::npos) << run.out;
}

TEST_F(Library, WhatOpenScadMissedIsSaidWhereThereIsNoModel) {
    folder_.write("m.scad", "use <nowhere.scad>\npart();\n");
    const Outcome run = folder_.cardioid({"info", "m.scad"});
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("finds no model in it: "), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("nowhere.scad"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace cardioid::test

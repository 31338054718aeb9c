#include <gtest/gtest.h>

#include "tests/language/read.hpp"

using cardioid::test::contains;
using cardioid::test::error_of;

namespace {

void expect_program(const std::string& text, const std::string& place) {
    const std::string message = error_of(text);
    EXPECT_TRUE(contains(message, "this is an OpenSCAD program: run openscad -o m.csg m.scad")) << text << message;
    EXPECT_TRUE(message.starts_with("t.csg:" + place + ": found ")) << text << message;
}

}  // namespace

TEST(ParserErrors, SendProgramsToOpenscad) {
    expect_program("for (i = [0:3]) cube(i);", "1:1");
    expect_program("cube(1);\nmodule m() { cube(); }", "2:1");
    expect_program("x = 3;", "1:1");
    expect_program("$fn = 30;", "1:1");
    expect_program("if (true) cube(1);", "1:1");
    expect_program("include <other.scad>\n", "1:1");
    expect_program("use <MCAD/boxes.scad>", "1:1");
    expect_program("cube(1 + 2);", "1:8");
    expect_program("cube(a * 2);", "1:8");
    expect_program("cube(sin(30));", "1:6");
    expect_program("cube((3));", "1:6");
    expect_program("cube(-a);", "1:7");
    expect_program("cube(a ? 1 : 2);", "1:8");
    expect_program("cube([for (i = [0:2]) i]);", "1:7");
    expect_program("union() { function f(x) = x; }", "1:11");
}

TEST(ParserErrors, NamePlaceWhatWasFoundAndWhatWasWanted) {
    EXPECT_EQ(error_of("cube(1)\n  42;"), "t.csg:2:3: found \"42\", wanted ';', '{' or a call");
    EXPECT_EQ(error_of("cube 1;"), "t.csg:1:6: found \"1\", wanted '(' behind \"cube\"");
    EXPECT_EQ(error_of("cube(1,);"), "t.csg:1:8: found \")\", wanted a value");
    EXPECT_EQ(error_of("cube(1"), "t.csg:1:7: found the end of the file, wanted ',' or ')'");
    EXPECT_EQ(error_of("cube([1, 2"), "t.csg:1:11: found the end of the file, wanted ',' or ']'");
    EXPECT_EQ(error_of("union() {\ncube();\n"),
              "t.csg:3:1: found the end of the file, wanted '}' for union() of line 1");
    EXPECT_EQ(error_of("cube(); }"), "t.csg:1:9: found \"}\", wanted a call");
    EXPECT_EQ(error_of("#;"), "t.csg:1:2: found \";\", wanted a call");
    EXPECT_EQ(error_of("cube(\"abc"), "t.csg:1:6: found a text that is not closed, wanted '\"'");
    EXPECT_EQ(error_of("/* cube();"), "t.csg:1:1: found a comment that is not closed, wanted \"*/\"");
}

TEST(ParserErrors, RejectNumbersNoDoubleHolds) {
    EXPECT_EQ(error_of("cube();\ncube(1e400);"), "t.csg:2:6: found \"1e400\", wanted a number below 1.8e308");
    EXPECT_TRUE(contains(error_of("cube(" + std::string(400, '9') + ");"), "wanted a number below 1.8e308"));
}

TEST(ParserErrors, SuggestTheNearestCall) {
    EXPECT_EQ(error_of("sphre(r = 1);"), "t.csg:1:1: no call \"sphre\" (did you mean \"sphere\"?)");
    EXPECT_EQ(error_of("area_ligth([1, 1]);"), "t.csg:1:1: no call \"area_ligth\" (did you mean \"area_light\"?)");
    EXPECT_EQ(error_of("Cube();"), "t.csg:1:1: no call \"Cube\" (did you mean \"cube\"?)");
    EXPECT_EQ(error_of("xyzzy();"), "t.csg:1:1: no call \"xyzzy\"");
}

TEST(ParserErrors, RefuseNodesOfLaterVersionsByNameAndPlace) {
    for (const char* name : {"animate"})
        EXPECT_EQ(error_of("group() {\n\t" + std::string(name) + "() cube();\n}"),
                  "t.csg:2:2: " + std::string(name) + "() is not supported yet");
    EXPECT_TRUE(contains(error_of("import(file = \"a.step\");"), "t.csg:1:1: found \"a.step\", can import STL, "));
}

TEST(ParserErrors, NameTheArgumentOfTheWrongType) {
    EXPECT_EQ(error_of("sphere(r = \"big\");"), "t.csg:1:8: r of sphere() must be a number");
    EXPECT_EQ(error_of("cube(center = [1]);"), "t.csg:1:6: center of cube() must be true or false");
    EXPECT_EQ(error_of("cube([1]);"), "t.csg:1:6: size of cube() must be a number or a list of numbers, as [1, 2, 3]");
    EXPECT_EQ(error_of("multmatrix(3) cube();"),
              "t.csg:1:12: m of multmatrix() must be a list of 4 lists of 4 numbers");
}

TEST(ParserErrors, AnEmptyFileIsNoScene) {
    EXPECT_TRUE(contains(error_of(""), "t.csg:1:1: found an empty file"));
    EXPECT_TRUE(contains(error_of(" \n // nothing\n"), "t.csg:1:1: found an empty file"));
}

TEST(ParserErrors, ArgumentsUnknownOrTwiceAreWarnedOfOnce) {
    const auto scene = cardioid::test::read("cube(size = 1, centre = true); cube(size = 2, centre = true, size = 3);");
    EXPECT_EQ(cardioid::test::warnings_of(scene),
              "t.csg:1:16: cube() has no parameter \"centre\" (did you mean \"center\"?): ignored\n"
              "t.csg:1:62: size is given twice: the last counts\n");
    EXPECT_EQ(scene.solids.leaves[1].to_world.row[0].x, 3);
}

TEST(ParserErrors, AnUnknownCallIsAGroupWhereAskedFor) {
    cardioid::ReadOptions options;
    options.unknown_is_warning = true;
    const auto scene = cardioid::test::read("hul() { cube(); sphere(); } hul() cube();", options);
    EXPECT_EQ(cardioid::test::tree_of(scene), "box ball box");
    EXPECT_EQ(scene.warnings.size(), 1U);
}

TEST(ParserErrors, WarningsAreBounded) {
    std::string text;
    for (int i = 0; i < 1000; ++i) text += "cube(0);\n";
    const auto scene = cardioid::test::read(text);
    EXPECT_EQ(scene.warnings.size(), 101U);
    EXPECT_EQ(scene.warnings.back(), "900 more warnings were left out");
}

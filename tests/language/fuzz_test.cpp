#include <chrono>
#include <gtest/gtest.h>
#include <random>

#include "formats/openscad/openscad_format.hpp"
#include "formats/openscad/syntax/parser.hpp"
#include "formats/openscad/syntax/printer.hpp"
#include "tests/language/read.hpp"

using namespace cardioid;
using cardioid::test::contains;

namespace {

constexpr const char* sample =
    "group() {\n\tdifference() {\n\t\tcube(size = [10, 10, 10], center = true);\n%\tsphere($fn = 0, $fa = 12, $fs = 2, "
    "r = 5);\n"
    "\t\tmultmatrix([[1, 0, 0, 11], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {\n\t\t\tcylinder($fn = 6, h = 10, r1 = "
    "5, r2 "
    "= 0, center = true);\n\t\t}\n\t}\n\tlinear_extrude(height = 5, twist = 30, scale = [1, 2]) {\n\t\tdifference() { "
    "square(size = [4, 5], center = false); circle(r = 1); polygon(points = [[0, 0], [1, 0], [0, 1]], paths = undef); "
    "}\n\t}\n"
    "\trotate_extrude(angle = 90) { translate([5, 0]) circle(r = 1); }\n"
    "\tpolyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = [[0,1,2],[0,3,1],[0,2,3],[1,3,2]], convexity = "
    "1);\n"
    "}\ndefine_material(\"m\", kind = \"diffuse\", reflectance = [0.1, 0.2, 0.3]);\nmaterial(\"m\") color([1, 0, 0, "
    "0.5]) "
    "torus(5, 1);\n%text(text = \"@cardioid material('m')\", size = 0.001);\ncamera([1, 2, 3]); film([8, 8]); /* x */ "
    "// y\n";

/// Reads; whatever is wrong must be an Error.
void try_read(const std::string& text) {
    try {
        const Scene scene = test::read(text);
        EXPECT_FALSE(formats::csg_format.write(scene, {}).empty());
    } catch (const Error& e) {
        EXPECT_TRUE(e.code() == ErrorCode::bad_input || e.code() == ErrorCode::io || e.code() == ErrorCode::limit);
        EXPECT_TRUE(std::string(e.what()).starts_with("t.csg:")) << e.what();
    }
}

std::string repeat(const std::string& text, int times) {
    std::string out;
    for (int i = 0; i < times; ++i) out += text;
    return out;
}

double seconds(const std::string& text) {
    const auto start = std::chrono::steady_clock::now();
    try_read(text);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST(Fuzz, EveryTruncationIsReadOrRefused) {
    const std::string text = sample;
    for (std::size_t n = 0; n < text.size(); n += 3) try_read(text.substr(0, n));
}

TEST(Fuzz, FlippedBitsAreReadOrRefused) {
    std::mt19937 random(1);
    for (int run = 0; run < 2000; ++run) {
        std::string text = sample;
        for (auto flips = 1 + random() % 4; flips > 0; --flips)
            text[random() % text.size()] ^= static_cast<char>(1U << random() % 7);
        try_read(text);
    }
}

TEST(Fuzz, ExchangedPiecesAreReadOrRefused) {
    static constexpr const char* pieces[] = {"cube",       "(",       ")",
                                             "{",          "}",       "[",
                                             "]",          ",",       ";",
                                             "=",          "1",       "-",
                                             "\"x\"",      "nan",     "inf",
                                             "undef",      ":",       "%",
                                             "!",          "square",  "linear_extrude",
                                             "difference", "polygon", "$fn",
                                             "1e308",      "'",       "\\",
                                             "function",   "text",    "\"@cardioid end\""};
    std::mt19937 random(2);
    for (int run = 0; run < 5000; ++run) {
        std::string text;
        for (auto n = 1 + random() % 30; n > 0; --n) text += pieces[random() % std::size(pieces)];
        try_read(text);
    }
}

TEST(Fuzz, BinaryFilesAreRefused) {
    std::mt19937 random(3);
    for (int run = 0; run < 200; ++run) {
        std::string text(1 + random() % 500, '\0');
        for (char& c : text) c = static_cast<char>(random());
        try_read(text);
    }
    EXPECT_TRUE(contains(test::error_of(std::string("\0\1\2", 3)), "t.csg:1:1: found \"\\x00\", wanted a call"));
    EXPECT_TRUE(contains(test::error_of("\x7F"
                                        "ELF"),
                         "found \"\\x7f\""));
}

TEST(Fuzz, AHundredThousandLevelsAreTheLimit) {
    constexpr int limit = formats::openscad::nesting_limit;
    const std::string deep = repeat("group(){\n", limit) + "cube();" + repeat("}", limit);
    EXPECT_EQ(test::tree_of(test::read(deep)), "box");
    const std::string message = test::error_of(repeat("group(){\n", limit + 2));
    EXPECT_EQ(message,
              "t.csg:100002:1: found more than 100000 calls inside one another; --set csg.nesting allows more");
    EXPECT_TRUE(contains(test::error_of(repeat("group() ", limit + 1) + "cube();"), "calls inside one another"));
    EXPECT_TRUE(contains(test::error_of("cube(" + repeat("[", limit + 1)), "lists inside one another"));
}

TEST(Fuzz, DeepTreesOfEveryKindNeedNoStack) {
    constexpr int deep = 90'000;
    for (const std::string open :
         {"difference(){cube();", "intersection(){cube();", "translate([1,0,0]){cube();", "color(\"red\"){",
          "linear_extrude(1){square();", "material(\"default\"){sphere();"}) {
        const std::string text = repeat(open, deep) + "cube();" + repeat("}", deep);
        EXPECT_LT(seconds(text), 20) << open;
    }
    const auto ast = formats::openscad::parse("f(" + repeat("[", deep) + "1" + repeat("]", deep) + ");", "t.csg");
    EXPECT_TRUE(equal(ast, formats::openscad::parse(formats::openscad::print(ast), "p")));
}

TEST(Fuzz, TimeIsInProportionToTheText) {
    const auto text = [](int n) {
        std::string out = "polyhedron(points = [";
        for (int i = 0; i < n; ++i)
            out += (i > 0 ? ", [" : "[") + std::to_string(i % 97) + ".125, " + std::to_string(i % 89) + ", " +
                   std::to_string(i) + "]";
        out += "], faces = [";
        for (int i = 0; i + 2 < n; ++i)
            out += (i > 0 ? ", [" : "[") + std::to_string(i) + ", " + std::to_string(i + 1) + ", " +
                   std::to_string(i + 2) + "]";
        return out + "]);";
    };
    const std::string large = text(50'000);
    const auto start = std::chrono::steady_clock::now();
    const auto ast = formats::openscad::parse(large, "t.csg");
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_EQ(ast.numbers.size(), 3U * 50'000 + 3U * 49'998);
    EXPECT_LT(took, 3.0 * static_cast<double>(large.size()) / 1e6) << "100 MB a few seconds; 60 times that is a fault";
}

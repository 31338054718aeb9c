#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>
#include <unistd.h>

#include "csg/compile.hpp"
#include "csg/measure.hpp"
#include "formats/brlcad/brlcad_format.hpp"
#include "rt_core/render/commit/scene_digest.hpp"
#include "rt_core/scene/scene.hpp"
#include "tests/brlcad/database_writer.hpp"

namespace cardioid::formats {
namespace {

using W = test::DatabaseWriter;
constexpr double pi_d = std::numbers::pi;

/// A folder for the files of grids, gone at the end.
class Folder {
public:
    Folder() : path_(std::filesystem::path(testing::TempDir()) / fmt::format("cardioid_brlcad_grids_{}", getpid())) {
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    void write(const char* name, const std::string& bytes) const {
        std::ofstream(path_ / name, std::ios::binary) << bytes;
    }
    [[nodiscard]] Scene scene_of(const std::string& text) const {
        return brlcad_format.read(text, (path_ / "model").string(), {});
    }

private:
    std::filesystem::path path_;
};

void expect_volume(const Scene& scene, double wanted, const std::string& what) {
    EXPECT_TRUE(scene.warnings.empty()) << what << ": " << scene.warnings[0];
    const auto region = csg::compile_whole(scene.solids, false);
    const csg::VolumeEstimate found = csg::measure_volume(*region, region->bounds(), 96, 1);
    EXPECT_NEAR(found.volume, wanted, 4 * found.sigma + 1e-6 * wanted) << what;
    EXPECT_LT(found.sigma, 5e-3 * wanted) << what;
}

Scene scene_of(const std::string& text) { return brlcad_format.read(text, "model", {}); }
void expect_volume(const std::string& text, double wanted) { expect_volume(scene_of(text), wanted, text); }

/// The binary form of one solid.
std::string binary(int minor, const std::string& body) {
    W out;
    out.add(1, minor, "a", {}, body);
    return out.bytes();
}

std::string warning_of(const Scene& scene) { return scene.warnings.empty() ? "" : scene.warnings[0]; }

/// The text with a ball at its side, so that there is a scene even where the solid is left out.
std::string warning_beside_a_ball(const std::string& text) {
    return warning_of(scene_of("put b ell V {0 0 0} A {1 0 0} B {0 1 0} C {0 0 1}\n" + text));
}

constexpr const char* identity = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1";

/// 4 x 3 heights, some of them 0.
const std::vector<unsigned> terrain{700, 600, 650, 800, 0, 900, 800, 750, 0, 0, 850, 600};
std::string terrain_bytes() {
    std::string out;
    for (const unsigned h : terrain) out += W::whole(h, 2);
    return out;
}
/// The sum over both triangles of each cell of a third of their corners' heights times half a cell.
double terrain_volume(bool rising) {
    double sum = 0;
    for (std::size_t y = 0; y < 2; ++y)
        for (std::size_t x = 0; x < 3; ++x) {
            const double a = terrain[y * 4 + x], b = terrain[y * 4 + x + 1];
            const double c = terrain[y * 4 + x + 4], d = terrain[y * 4 + x + 5];
            sum += (rising ? 2 * a + 2 * d + b + c : 2 * b + 2 * c + a + d) / 6;
        }
    return sum;
}

TEST(BrlcadGrids, DspsHaveTheVolumeOfTheirTrianglesAndAreTheSameFromEveryForm) {
    const Folder folder;
    folder.write("t.dsp", terrain_bytes());
    const auto text = [](const char* cut) {
        return fmt::format("put a dsp src f name t.dsp w 4 n 3 sm 0 cut {} stom {{2 0 0 5 0 3 0 6 0 0 0.5 7 0 0 0 1}}",
                           cut);
    };
    expect_volume(folder.scene_of(text("l")), 3 * terrain_volume(true), "rising");
    expect_volume(folder.scene_of(text("L")), 3 * terrain_volume(false), "falling");
    const std::uint64_t adaptive = scene_hash(folder.scene_of(text("a")));
    EXPECT_NE(adaptive, scene_hash(folder.scene_of(text("L"))));
    EXPECT_EQ(adaptive,
              scene_hash(folder.scene_of(
                  "I 1 v4\nx\ns dsp a file=\"t.dsp\" sm=0 w=4 n=3 stom=2,0,0,5,0,3,0,6,0,0,0.5,7,0,0,0,1\n")));
    const std::string head =
        W::whole(4, 4) + W::whole(3, 4) + W::reals({2, 0, 0, 5, 0, 3, 0, 6, 0, 0, 0.5, 7, 0, 0, 0, 1}) + W::whole(0, 2);
    EXPECT_EQ(adaptive, scene_hash(folder.scene_of(binary(25, head + "fa" + "t.dsp" + '\0'))));
    W within;
    within.add(9, 5, "numbers", {}, terrain_bytes());
    within.add(1, 25, "a", {}, head + "oa" + "numbers" + '\0');
    EXPECT_EQ(adaptive, scene_hash(scene_of(within.bytes())));
    std::string numbers;
    for (const unsigned h : terrain) numbers += fmt::format("{} ", h);
    EXPECT_EQ(adaptive, scene_hash(scene_of("put numbers binunif T S D {" + numbers +
                                            "}\nput a dsp src o name numbers w 4 n 3 sm 0 cut a stom {2 0 0 5 0 3 0 6 "
                                            "0 0 0.5 7 0 0 0 1}")));
}

TEST(BrlcadGrids, EbmsAndVolsAreTheBoxesOfTheirCells) {
    const Folder folder;
    folder.write("b.bw", std::string("\0\1\0\2\0\3\7\0\0", 9));
    expect_volume(folder.scene_of(fmt::format("put a ebm file b.bw w 3 n 3 d 2.5 mat {{{}}}", identity)), 4 * 2.5,
                  "ebm");
    const Scene old = folder.scene_of(fmt::format("I 1 v4\nx\ns ebm a file=\"b.bw\" w=3 n=3 d=2.5 mat={}\n", identity));
    EXPECT_EQ(
        scene_hash(old),
        scene_hash(folder.scene_of(binary(12, fmt::format("file=\"b.bw\" w=3 n=3 d=2.5 mat={}", identity) + '\0'))));
    expect_volume(old, 4 * 2.5, "ebm of version 4");
    const std::string cells{0, 9, 20, 5, 20, 9, 0, 9};
    folder.write("v.bw", cells);
    expect_volume(folder.scene_of("put a vol file v.bw w 2 n 2 d 2 lo 5 hi 10 size {1 2 3}"), 4 * 6, "vol");
    expect_volume(folder.scene_of("I 1 v4\nx\ns vol a file=\"v.bw\" w=2 n=2 d=2 lo=5 hi=10 size=1,2,3\n"), 4 * 6,
                  "vol of version 4");
}

TEST(BrlcadGrids, HfsStandOnTheirOwnAxes) {
    const Folder folder;
    folder.write("h", W::reals({1, 2, 3, 4}));
    expect_volume(folder.scene_of("put a hf dfile h fmt nd w 2 n 2 file2mm 2 v {1 2 3} x {0 2 0} y {0 0 5} xlen 4 ylen "
                                  "6 zscale 0.5"),
                  4 * 6 * (2 * 1 + 2 * 4 + 2 + 3) / 6.0, "hf");
}

TEST(BrlcadGrids, WithoutTheirDataAreLeftOutByName) {
    const std::string rest = " w 4 n 3 sm 0 cut a stom {1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1}";
    EXPECT_NE(warning_beside_a_ball("put a dsp src f name gone.dsp" + rest).find("gone.dsp\", which is not there"),
              std::string::npos);
    EXPECT_NE(warning_beside_a_ball("put a dsp src o name b" + rest).find("\"b\", which holds no numbers"),
              std::string::npos);
    EXPECT_NE(warning_beside_a_ball("put n binunif T S D {1 2 3}\nput a dsp src o name n" + rest).find("wanted 24"),
              std::string::npos);
    EXPECT_NE(warning_beside_a_ball("put a dsp src o name n w 1e9 n 3").find("1000000000 for w"), std::string::npos);
    EXPECT_NE(warning_beside_a_ball("put a ebm file x w 2 n 2 d 1 mat {1 2}").find("wanted 16 numbers"),
              std::string::npos);
}

TEST(BrlcadPrimitives, SuperellsOfGreatExponentsHaveTheVolumesOfTheirFormulas) {
    for (const auto& [n, e] : {std::pair{3.0, 3.0}, {2.5, 1.0}, {1.0, 4.0}, {0.5, 2.5}, {3.0, 0.5}}) {
        const double wanted = 24 * 2 * n * e * std::beta(n / 2 + 1, n) * std::beta(e / 2, e / 2);
        expect_volume(fmt::format("put a superell V {{1 2 3}} A {{2 0 0}} B {{0 3 0}} C {{0 0 4}} n {} e {}", n, e),
                      wanted);
    }
}

TEST(BrlcadPrimitives, MetaballsOfOnePointAreBallsOfEachMethod) {
    // Fields are at their thresholds at sqrt(f^2 / t); f sqrt(1 - ln(t) / s); f (1 - sqrt(t / 1.5)).
    const double one = 2 / std::sqrt(0.5), two = 2 * std::sqrt(1 - std::log(0.5) / 3), none = 2 * (1 - std::sqrt(0.2));
    expect_volume("put a metaball 1 0.5 {{1 2 3 2 3}}", 4.0 / 3 * pi_d * std::pow(one, 3));
    expect_volume("put a metaball 2 0.5 {{1 2 3 2 3}}", 4.0 / 3 * pi_d * std::pow(two, 3));
    expect_volume("put a metaball 0 0.3 {{1 2 3 2 3}}", 4.0 / 3 * pi_d * std::pow(none, 3));
    const Scene text = scene_of("put a metaball 1 0.5 {{1 2 3 2 3}{4 5 6 -1 1}}");
    EXPECT_EQ(scene_hash(text), scene_hash(scene_of(binary(36, W::whole(2, 4) + W::whole(1, 4) +
                                                                   W::reals({0.5, 1, 2, 3, 2, 3, 4, 5, 6, -1, 1})))));
    EXPECT_NE(warning_beside_a_ball("put a metaball 1 0 {{1 2 3 2 3}}").find("no threshold above 0"),
              std::string::npos);
}

TEST(BrlcadPrimitives, ArssAreTheSolidsBetweenTheirCurves) {
    // A square bipyramid: two points and a square between them.
    const std::string text =
        "put a ars NC 3 PPC 4 C0 {{0 0 3} {0 0 3} {0 0 3} {0 0 3}} C1 {{2 0 0} {0 2 0} {-2 0 0} {0 -2 0}} C2 {{0 0 -1} "
        "{0 0 -1} {0 0 -1} {0 0 -1}}";
    expect_volume(text, 8 * 4 / 3.0);
    const std::uint64_t hash = scene_hash(scene_of(text));
    EXPECT_EQ(hash,
              scene_hash(scene_of(binary(5, W::whole(3, 4) + W::whole(4, 4) +
                                                W::reals({0, 0, 3, 0,  0, 3, 0, 0,  3, 0, 0,  3, 2, 0,  0, 0, 2, 0, -2,
                                                          0, 0, 0, -2, 0, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1})))));
    EXPECT_EQ(hash, scene_hash(scene_of("I 1 v4\nx\nA 5 a 3 4 1 3\nB 6 1 1 0 0 3 0 0 0 0 0 0 0 0 0\n"
                                        "B 6 2 1 2 0 -3 0 2 -3 -2 0 -3 0 -2 -3\n"
                                        "B 6 3 1 0 0 -4 0 0 -4 0 0 -4 0 0 -4\n")));
}

TEST(BrlcadPrimitives, PlatesHaveTheirThicknessOnTheSideTheySay) {
    const std::string faces =
        " orient no V {{0 0 0} {3 0 0} {0 3 0} {9 0 0} {9 3 0}} F {{0 1 2} {1 3 4}} T {0.5 0.25} ";
    const double volume = 0.5 * 4.5 + 0.25 * 9;
    const Scene plates = scene_of("put a bot mode plate" + faces + "fm 01");
    expect_volume(plates, volume, "plates");
    const Box3d box = csg::compile_whole(plates.solids, false)->bounds();
    EXPECT_DOUBLE_EQ(box.lo.z, -0.5);   // the first is appended
    EXPECT_DOUBLE_EQ(box.hi.z, 0.125);  // the second is centred
    std::string body = W::whole(5, 4) + W::whole(2, 4) + std::string("\1\3\0", 3) +
                       W::reals({0, 0, 0, 3, 0, 0, 0, 3, 0, 9, 0, 0, 9, 3, 0});
    for (const unsigned corner : {0, 1, 2, 1, 3, 4}) body += W::whole(corner, 4);
    body += W::reals({0.5, 0.25}) + "01" + '\0';
    EXPECT_EQ(scene_hash(plates), scene_hash(scene_of(binary(30, body))));
    EXPECT_EQ(scene_hash(plates),
              scene_hash(scene_of("I 1 v4\nx\nt a 3 1 0 5 2\n 0: 0 0 0\n 1: 3 0 0\n 2: 0 3 0\n 3: 9 0 0\n 4: 9 3 0\n"
                                  " 0: 0 1 2 0.5 1\n 1: 1 3 4 0.25 0\n")));
}

TEST(BrlcadPrimitives, PolysAndClinesHaveTheVolumesOfTheirFormulas) {
    expect_volume(
        "I 1 v4\nx\nP a\nQ 3 0 0 0 0 3 0 3 0 0\nQ 3 0 0 0 3 0 0 0 0 3\nQ 3 3 0 0 0 3 0 0 0 3\nQ 3 0 3 0 0 0 0 0 0 3\n",
        4.5);
    expect_volume("put a cline V {1 2 3} H {0 3 4} r 2 t 0", 5 * pi_d * 4);
    expect_volume("I 1 v4\nx\nc a 1 2 3 0 3 4 2 0.5\n", 5 * pi_d * (4 - 2.25));
    expect_volume(binary(29, W::reals({0.5, 2, 1, 2, 3, 0, 3, 4})), 5 * pi_d * (4 - 2.25));
}

TEST(BrlcadPrimitives, NurbsOfSketchesAreTheirCurves) {
    // A quarter of a circle as a rational curve of second degree, closed by two lines.
    const double w = std::sqrt(0.5);
    const std::string ends = " {line S 0 E 1} {line S 3 E 0}", vertices = "VL {{0 0} {2 0} {2 2} {0 2}}";
    const std::string text = fmt::format(
        "put s sketch V {{0 0 0}} A {{1 0 0}} B {{0 1 0}} {} SL {{{} {{nurb O 3 T 5 K {{0 0 0 1 1 1}} P {{1 2 3}} W "
        "{{1 {} "
        "1}}}}}}\nput a extrude V {{0 0 0}} H {{0 0 5}} A {{1 0 0}} B {{0 1 0}} S s",
        vertices, ends, w);
    const auto region = csg::compile_whole(scene_of(text).solids, false);
    const csg::VolumeEstimate found = csg::measure_volume(*region, region->bounds(), 96, 1);
    EXPECT_NEAR(found.volume, 5 * pi_d, 4 * found.sigma + 1e-5 * 5 * pi_d);
    std::string body =
        W::reals({0, 0, 0, 1, 0, 0, 0, 1, 0}) + W::whole(4, 4) + W::whole(3, 4) + W::reals({0, 0, 2, 0, 2, 2, 0, 2});
    for (const unsigned x : {0x6C736567U, 0U, 1U, 0x6C736567U, 3U, 0U, 0x6E757262U, 3U, 5U, 6U}) body += W::whole(x, 4);
    body += W::reals({0, 0, 0, 1, 1, 1}) + W::whole(3, 4) + W::whole(1, 4) + W::whole(2, 4) + W::whole(3, 4) +
            W::reals({1, w, 1});
    W out;
    out.add(1, 26, "s", {}, body);
    out.add(1, 27, "a", {}, W::reals({0, 0, 0, 0, 0, 5, 1, 0, 0, 0, 1, 0}) + W::whole(0, 4) + "s" + '\0');
    EXPECT_EQ(scene_hash(scene_of(out.bytes())), scene_hash(scene_of(text)));
}

TEST(BrlcadPrimitives, SketchesOfVersion4AreThoseOfVersion5) {
    const std::string old =
        "I 1 v4\nx\nd s 0 0 0 1 0 0 0 1 0 4 4\n 0 0 2 0 2 2 0 2\n  L 0 0 1\n  A 0 1 2 1 1 0\n  L 0 2 3\n  L 0 3 0\n"
        "e a s 0 0 0 0 0 0 5 1 0 0 0 1 0\n";
    const std::string text =
        "put s sketch V {0 0 0} A {1 0 0} B {0 1 0} VL {{0 0} {2 0} {2 2} {0 2}} SL {{line S 0 E 1} {carc S 1 E 2 R 1 "
        "L "
        "1 O 0} {line S 2 E 3} {line S 3 E 0}}\nput a extrude V {0 0 0} H {0 0 5} A {1 0 0} B {0 1 0} S s";
    EXPECT_EQ(scene_hash(scene_of(old)), scene_hash(scene_of(text)));
    expect_volume(old, 5 * (4 + pi_d / 2));
}

TEST(BrlcadPrimitives, ThatAreNoSolidsAreNamed) {
    for (const char* type : {"grip", "joint", "pnts", "nmg", "brep", "bspline", "submodel"})
        EXPECT_NE(warning_beside_a_ball(fmt::format("put a {} x y", type)).find(fmt::format("type \"{}\"", type)),
                  std::string::npos)
            << type;
}

TEST(BrlcadPrimitives, CutShortAreErrorsWithTheirPlace) {
    const std::string bodies[] = {W::whole(1U << 30, 4) + W::whole(1U << 30, 4), W::whole(1U << 31, 4),
                                  W::whole(4, 4) + W::whole(3, 4), W::whole(1U << 31, 4) + W::whole(1, 4)};
    const int minors[] = {5, 8, 25, 36};
    for (std::size_t i = 0; i < 4; ++i) try {
            static_cast<void>(scene_of(binary(minors[i], bodies[i])));
            FAIL() << minors[i];
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::bad_input);
            EXPECT_NE(std::string(error.what()).find("model:"), std::string::npos) << error.what();
        }
}

}  // namespace
}  // namespace cardioid::formats

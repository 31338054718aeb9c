#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "csg/compile.hpp"
#include "csg/measure.hpp"
#include "formats/brlcad/brlcad_format.hpp"
#include "formats/brlcad/view/view_script.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats {
namespace {

constexpr double pi_d = std::numbers::pi;

Scene scene_of(const std::string& text) { return brlcad_format.read(text, "model.asc", {}); }

void expect_volume(const std::string& text, double wanted) {
    const Scene scene = scene_of(text);
    EXPECT_TRUE(scene.warnings.empty()) << text << scene.warnings[0];
    const auto region = csg::compile_whole(scene.solids, false);
    const csg::VolumeEstimate found = csg::measure_volume(*region, region->bounds(), 128, 1);
    EXPECT_NEAR(found.volume, wanted, 4 * found.sigma + 1e-6 * wanted) << text;
    EXPECT_LT(found.sigma, 5e-3 * wanted) << text;
}

TEST(BrlcadSolids, HaveTheVolumesOfTheirFormulas) {
    expect_volume("put a ell V {1 2 3} A {2 0 0} B {0 3 0} C {0 0 4}", 4.0 / 3 * pi_d * 24);
    expect_volume("put a tor V {1 2 3} H {0 1 1} r_a 5 r_h 2", 2 * pi_d * pi_d * 5 * 4);
    expect_volume("put a tgc V {0 0 0} H {3 0 9} A {4 0 0} B {0 4 0} C {4 0 0} D {0 4 0}", pi_d * 16 * 9);
    expect_volume("put a tgc V {0 0 0} H {0 0 9} A {4 0 0} B {0 3 0} C {2 0 0} D {0 1.5 0}",
                  pi_d * 12 * 9 * (1 + 0.5 + 0.25) / 3);
    expect_volume("put a tgc V {0 0 0} H {0 0 9} A {2 0 0} B {0 1 0} C {4 0 0} D {0 4 0}",
                  pi_d * 9 * (16 * (1 - (0.5 + 0.75) / 2 + 0.5 * 0.75 / 3)));
    expect_volume("put a eto V {0 0 0} N {0 0 1} C {2 0 2} r 6 r_d 1", 2 * pi_d * 6 * pi_d * std::sqrt(8.0));
    expect_volume("put a rpc V {0 0 0} H {0 5 0} B {0 0 3} r 2", 4.0 / 3 * 2 * 3 * 5);
    expect_volume("put a epa V {0 0 0} H {0 0 3} A {1 0 0} r_1 2 r_2 1", pi_d / 2 * 2 * 3);
    expect_volume("put a hyp V {0 0 0} H {0 0 6} A {2 0 0} b 3 bnr 0.5", pi_d * 6 * 6 * (0.25 + 0.75 / 3));
    expect_volume("put a superell V {0 0 0} A {2 0 0} B {0 3 0} C {0 0 4} n 1 e 1", 4.0 / 3 * pi_d * 24);
    // Two balls and the frustum that touches both: caps of h (3r - h) pi h / 3.
    const double s = (3.0 - 1) / 8, c = std::sqrt(1 - s * s), h = 8 - 2 * s, r0 = 3 * c, r1 = c;
    const auto cap = [](double r, double t) { return pi_d * t * t * (3 * r - t) / 3; };
    expect_volume("put a part V {0 0 0} H {0 0 8} r_v 3 r_h 1",
                  pi_d * h * (r0 * r0 + r0 * r1 + r1 * r1) / 3 + cap(3, 3 * (1 + s)) + cap(1, 1 - s));
    expect_volume("put a pipe V0 {0 0 0} I0 2 O0 4 R0 5 V1 {20 0 0} I1 2 O1 4 R1 5 V2 {20 20 0} I2 2 O2 4 R2 5",
                  pi_d * (4 - 1) * (15 + 15 + 5 * pi_d / 2));
    expect_volume("put a arb8 V1 {0 0 0} V2 {4 0 0} V3 {4 4 0} V4 {0 4 0} V5 {1 1 3} V6 {3 1 3} V7 {3 3 3} V8 {1 3 3}",
                  28);
    expect_volume("put a arb8 V1 {0 0 0} V2 {3 0 0} V3 {0 3 0} V4 {0 3 0} V5 {0 0 3} V6 {0 0 3} V7 {0 0 3} V8 {0 0 3}",
                  4.5);
    expect_volume("put a arbn P0 {1 0 0 1} P1 {-1 0 0 1} P2 {0 1 0 1} P3 {0 -1 0 1} P4 {0 0 1 1} P5 {0 0 -1 1}", 8);
    expect_volume(
        "put a bot mode volume orient cw V {{0 0 0} {3 0 0} {0 3 0} {0 0 3}} F {{0 1 2} {0 3 1} {1 3 2} {2 3 0}}", 4.5);
}

/// A square of 4 x 6 from (1, 0), with a round hole of radius 1, or rounded by a half circle or a parabola.
std::string sketch_of(const std::string& curves) {
    return "put s sketch V {0 0 0} A {1 0 0} B {0 1 0} VL {{1 0} {5 0} {5 6} {1 6} {3 3} {4 3} {9 3}} SL {" + curves +
           "}\n";
}

TEST(BrlcadSolids, OfSketchesHaveTheVolumesOfTheirFormulas) {
    const std::string lower = "{line S 0 E 1} {line S 3 E 2} {line S 3 E 0} ", right = "{line S 1 E 2} ";
    const std::string hole = "{carc S 5 E 4 R -1 L 0 O 0} ", bow = "{carc S 1 E 2 R 3 L 1 O 0} ";
    const std::string parabola = "{bezier D 2 P {1 6 2}} ";
    const std::string extrude = "put a extrude V {1 2 3} H {1 0 5} A {1 0 0} B {0 1 0} S s",
                      pi_text = "3.141592653589793";
    expect_volume(sketch_of(lower + right) + extrude, 24 * 5);
    expect_volume(sketch_of(lower + right + hole) + extrude, (24 - pi_d) * 5);
    expect_volume(sketch_of(lower + bow) + extrude, (24 + pi_d * 9 / 2) * 5);
    expect_volume(sketch_of(lower + parabola) + extrude, (24 + 2.0 / 3 * 6 * 2) * 5);
    // Pappus: the middle of the square goes round at 3.
    const std::string revolve = "put a revolve V {1 2 3} axis {0 1 2} R {1 0 0} sk_name s ang ";
    expect_volume(sketch_of(lower + right) + revolve + "6.283185307179586", 2 * pi_d * 3 * 24);
    expect_volume(sketch_of(lower + right + hole) + revolve + "6.283185307179586", 2 * pi_d * 3 * (24 - pi_d));
    expect_volume(sketch_of(lower + right) + revolve + "1.0", 3 * 24);
    expect_volume(sketch_of(lower + right) + revolve + pi_text, pi_d * 3 * 24);
    expect_volume(sketch_of(lower + right) + revolve + "4.0", 4 * 3 * 24);
}

TEST(BrlcadSolids, OfSketchesThatAreNotThereOrOpenAreLeftOutWithANote) {
    const std::string ball = "put b ell V {0 0 0} A {1 0 0} B {0 1 0} C {0 0 1}\n";
    const std::string extrude = "put a extrude V {0 0 0} H {0 0 5} A {1 0 0} B {0 1 0} S ";
    for (const auto& [text, part] : {std::pair{extrude + "t", "not there"},
                                     {extrude + "b", "no sketch"},
                                     {sketch_of("{line S 0 E 1}") + extrude + "s", "not closed"}}) {
        const Scene scene = scene_of(ball + text);
        ASSERT_FALSE(scene.warnings.empty()) << text;
        EXPECT_NE(scene.warnings[0].find(part), std::string::npos) << scene.warnings[0];
    }
}

TEST(BrlcadSolids, OperationsMeanWhatTheySay) {
    const std::string two =
        "put a arb8 V1 {0 0 0} V2 {2 0 0} V3 {2 2 0} V4 {0 2 0} V5 {0 0 2} V6 {2 0 2} V7 {2 2 2} V8 {0 2 2}\n"
        "put b arb8 V1 {1 0 0} V2 {4 0 0} V3 {4 2 0} V4 {1 2 0} V5 {1 0 2} V6 {4 0 2} V7 {4 2 2} V8 {1 2 2}\n";
    const auto with = [&](const std::string& op) {
        return two + "put r comb region yes tree {" + op + " {l a} {l b}}\n";
    };
    expect_volume(with("u"), 16);
    expect_volume(with("-"), 4);
    expect_volume(with("n"), 4);
    expect_volume(with("^"), 12);
    // Above regions an operation works on each region of its left side.
    expect_volume(two +
                      "put ra comb region yes tree {l a}\nput rb comb region yes tree {l b}\n"
                      "put all comb region no tree {- {l ra} {l rb}}\n",
                  4);
    // The last element of a matrix divides: half the size.
    expect_volume(
        two.substr(0, two.find('\n') + 1) + "put r comb region yes tree {l a {1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 2}}\n", 1);
}

TEST(BrlcadLooks, OfAnUpperCombinationThatInheritsWin) {
    const std::string ball =
        "put s ell V {0 0 0} A {1 0 0} B {0 1 0} C {0 0 1}\nput r comb region yes tree {l s}\n"
        "attr set r rgb 255/0/0\nput top comb region no tree {l r}\n";
    const auto red = [](const Scene& scene) { return scene.materials.back().params.colour("reflectance", {}).r; };
    EXPECT_GT(red(scene_of(ball + "attr set top rgb 0/255/0\n")), 0.5F);
    EXPECT_EQ(red(scene_of(ball + "attr set top rgb 0/255/0 inherit 1\n")), 0);
}

TEST(BrlcadLooks, AirIsLeftOutAndMissingObjectsAreNamed) {
    const std::string text =
        "put s ell V {0 0 0} A {1 0 0} B {0 1 0} C {0 0 1}\nput air.r comb region yes tree {l s}\n"
        "attr set air.r aircode 1\nput ball.r comb region yes tree {l s}\n";
    EXPECT_EQ(scene_of(text).names, std::vector<std::string>{"/ball.r"});
    ReadOptions options;
    options.objects = {"bal.r"};
    try {
        static_cast<void>(brlcad_format.read(text, "m.asc", options));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::usage);
        EXPECT_NE(std::string(error.what()).find("did you mean \"ball.r\""), std::string::npos) << error.what();
    }
}

TEST(ViewScripts, RotationsQuaternionsAndAnglesAreTheSameView) {
    using namespace brlcad;
    const View angles = read_views("viewsize 10; eye_pt 1 2 3; ae 35 25; end;", "v.rt").front();
    const View rows = read_views(
                          "viewsize 10;\neye_pt 1 2 3;\nviewrot -.573576436 .819152044 0 0 -.346188613 -.242403876 "
                          ".906307787 0 .742403877 .519836826 .422618262 0 0 0 0 1;\nstart 0; end;",
                          "v.rt")
                          .front();
    for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(length((*angles.axes)[i] - (*rows.axes)[i]), 1e-7);
    const View quarter = read_views("orientation 0 0 0.70710678118654752 0.70710678118654752;", "v.rt").front();
    EXPECT_LT(length((*quarter.axes)[0] - Vec3d{0, 1, 0}), 1e-12);
    EXPECT_THROW(static_cast<void>(read_views("viewsise 10;", "v.rt")), Error);
    Scene scene;
    apply_views({angles}, scene);
    ASSERT_EQ(scene.cameras.size(), 1U);
    EXPECT_EQ(scene.cameras[0].width, 10);
    EXPECT_EQ(scene.cameras[0].projection, CameraSettings::Projection::orthographic);
}

TEST(ViewScripts, OfSeveralPicturesGiveACameraEach) {
    using namespace brlcad;
    const std::string one = "viewsize 10; eye_pt 1 2 3; start 0; end;";
    Scene scene;
    apply_views(read_views(one + " # start 1; end;\n", "v.rt"), scene);
    EXPECT_TRUE(scene.warnings.empty());
    ASSERT_EQ(scene.cameras.size(), 1U);
    scene = {};
    apply_views(
        read_views(
            one + "start 1; viewsize 20; end; start 7; clean; viewsize 1; eye_pt 9 0 0; set perspective=40; end;",
            "v.rt"),
        scene);
    ASSERT_EQ(scene.cameras.size(), 3U);
    EXPECT_EQ(scene.cameras[0].width, 10);
    EXPECT_EQ(scene.cameras[1].width, 20);
    EXPECT_EQ(scene.cameras[1].eye, (Vec3d{1, 2, 3})) << "what is not said again stays";
    EXPECT_EQ(scene.cameras[1].name, "1");
    EXPECT_EQ(scene.cameras[2].name, "7");
    EXPECT_EQ(scene.cameras[2].width, 1);
    EXPECT_EQ(scene.cameras[2].fov_deg, 40);
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_NE(scene.warnings[0].find("3 pictures; the first is drawn unless --camera names another: 0, 1, 7"),
              std::string::npos)
        << scene.warnings[0];
}

TEST(ViewScripts, AViewWithoutAnEyeIsLeftOutWithAWarning) {
    using namespace brlcad;
    Scene scene;
    apply_views(read_views("set width=64 height=48;", "v.rt"), scene);
    EXPECT_TRUE(scene.warnings.empty());
    apply_views(read_views("viewsize 10; orientation 0 0 0 1; end;", "v.rt"), scene);
    EXPECT_TRUE(scene.cameras.empty());
    EXPECT_FALSE(scene.fitted.parallel);
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_NE(scene.warnings[0].find("no eye_pt"), std::string::npos);
}

TEST(ViewScripts, AnglesWithoutAnEyeAreTheAutomaticView) {
    using namespace brlcad;
    Scene scene;
    apply_views(read_views("viewsize 10; ae 90 0; end;", "v.rt"), scene);
    EXPECT_TRUE(scene.cameras.empty());
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_TRUE(scene.fitted.parallel);
    EXPECT_EQ(scene.fitted.azimuth_deg, 90);
    EXPECT_EQ(scene.fitted.elevation_deg, 0);
    EXPECT_EQ(scene.fitted.width, 10);
}

}  // namespace
}  // namespace cardioid::formats

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "csg/exact/evaluate_mesh.hpp"
#include "csg/exact/section.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "tests/language/read.hpp"

// hull, minkowski, resize, projection, offset and fill against volumes that are known.
namespace {

using namespace cardioid;
using namespace cardioid::test;

constexpr double pi = std::numbers::pi;

double volume_of(const std::string& text, bool openscad_facets = false, double tolerance = 1e-4) {
    ReadOptions options;
    options.openscad_facets = openscad_facets;
    Scene scene = read(text, options);
    SolidTree& tree = scene.solids;
    const TriangleMesh mesh = csg::evaluate_mesh(tree, tree.add_node(SolidOp::unite, tree.roots), tolerance);
    EXPECT_TRUE(mesh.closed || mesh.triangles.empty()) << text;
    return csg::volume(mesh);
}

/// Volumes of figures one unit thick are their areas.
double area_of(const std::string& figure, bool openscad_facets = false) {
    return volume_of("linear_extrude(height = 1) " + figure, openscad_facets);
}

/// Area between a circle of radius r and chords that stay within `error` of it: two thirds of each chord's height
/// times its length, whatever the number of chords.
double area_beside_chords(double r, double error) { return 2.0 / 3 * error * 2 * pi * r; }

/// The area of a figure that is round in parts: `whole`, or up to `missing` less.
void expect_area_within(const std::string& figure, double whole, double missing) {
    const double area = area_of(figure);
    EXPECT_LE(area, whole * (1 + 1e-9)) << figure;
    EXPECT_GE(area, whole - missing) << figure;
}

TEST(Hull, OfTwoCubesIsTheSolidBetweenThem) {
    EXPECT_NEAR(volume_of("hull() { cube(2); translate([4, 0, 0]) cube(2); }"), 24, 1e-12);
}

TEST(Hull, OfTwoBallsIsACapsule) {
    const double capsule = 4.0 / 3 * pi + pi * 10;
    EXPECT_NEAR(volume_of("hull() { sphere(1); translate([0, 0, 10]) sphere(1); }"), capsule, 5e-3 * capsule);
}

TEST(Hull, OfADifferenceForgetsWhatIsCutFromItsMiddle) {
    EXPECT_NEAR(volume_of("hull() difference() { cube(4); translate([1, 1, -1]) cube([2, 2, 9]); }"), 64, 1e-9);
    EXPECT_NEAR(volume_of("hull() difference() { cube(4); translate([2, -1, -1]) cube(9); }"), 32, 1e-9);
}

TEST(Hull, StandsWhereTheTransformsAroundItSay) {
    const Scene scene = read("translate([1, 2, 3]) scale([2, 1, 1]) hull() { cube(1); translate([1, 0, 0]) cube(1); }");
    Box3d box;
    const Leaf& leaf = scene.solids.leaves[0];
    for (const Vec3d v : scene.solids.meshes[leaf.data]->vertices) box.include(leaf.to_world.point(v));
    EXPECT_EQ(box.lo, Vec3d(1, 2, 3));
    EXPECT_EQ(box.hi, Vec3d(5, 3, 4));
}

TEST(Hull, OfPointsInAPlaneOrOfNothingIsEmpty) {
    EXPECT_EQ(tree_of(read("cube(1); hull();")), "box");
    EXPECT_EQ(tree_of(read("cube(1); hull() { group(); }")), "box");
}

TEST(Hull, OfPlaneFiguresIsAPlaneFigure) {
    EXPECT_NEAR(area_of("hull() { square(1); translate([2, 0]) square(1); }"), 3, 1e-9);
    EXPECT_NEAR(area_of("hull() { circle(1); translate([4, 0]) circle(1); }"), pi + 8, 1e-3);
    EXPECT_EQ(area_of("hull() { polygon([[0, 0], [1, 0], [0.2, 0.2], [0, 1]]); }"), 0.5);
}

TEST(Hull, OfAHalfSpaceIsRefusedWithItsPlace) {
    EXPECT_TRUE(contains(error_of("cube(1);\nhull() half_space([0, 0, 1], 0);"), "t.csg:2:1: "));
}

TEST(Hull, OfWhatManyBoxesHaveInCommonTakesNoTime) {
    // Squares of side 2, turned in equal steps: a regular polygon of 4 n corners about a circle of radius 1.
    constexpr int n = 57;
    std::string boxes;
    for (int k = 0; k < n; ++k)
        boxes += "rotate([0, 0, " + std::to_string(90.0 * k / n) + "]) cube(2, center = true); ";
    EXPECT_NEAR(volume_of("hull() intersection() { " + boxes + "}"), 2 * 4 * n * std::tan(pi / (4 * n)), 1e-5);
}

TEST(Hull, OfWhatConvexSolidsHaveInCommonIsThat) {
    const auto common = [](const std::string& solids) { return volume_of("hull() intersection() { " + solids + "}"); };
    EXPECT_NEAR(common("cube(2); cube(2); translate([1, 1, 1]) cube(9);"), 1, 1e-15);
    EXPECT_NEAR(common("cube(2); translate([0, 0, -1]) cube([1, 2, 9]); translate([0.5, 0, -5]) cube(9);"), 2, 1e-15);
    EXPECT_EQ(tree_of(read("cube(7); hull() intersection() { cube(1); translate([1, 0, 0]) cube(1); cube(4); }")),
              "box");
    EXPECT_EQ(tree_of(read("cube(7); hull() intersection() { cube(1); translate([2, 0, 0]) cube(1); cube(4); }")),
              "box");
    // The octahedron |x| + |y| + |z| <= 3/2 within a cube of side 2: each of its six tips, of height 1/2, is cut off.
    const std::string tips =
        "polyhedron([[1.5,0,0],[-1.5,0,0],[0,1.5,0],[0,-1.5,0],[0,0,1.5],[0,0,-1.5]], [[4,2,0],"
        "[4,1,2],[4,3,1],[4,0,3],[5,0,2],[5,2,1],[5,1,3],[5,3,0]]);";
    EXPECT_NEAR(common("cube(2, center = true); " + tips + " cube([2, 2, 5], center = true);"), 4.5 - 6.0 / 12, 1e-12);
}

TEST(Minkowski, OfTwoCubesIsACube) {
    EXPECT_NEAR(volume_of("minkowski() { cube(2); cube([1, 2, 3]); }"), 3 * 4 * 5, 1e-9);
}

TEST(Minkowski, OfACubeAndABallIsARoundedCube) {
    const double rounded = 8 + 6 * 4 * 0.5 + 12 * pi * 0.25 / 4 * 2 + 4.0 / 3 * pi * 0.125;
    EXPECT_NEAR(volume_of("minkowski() { cube(2); sphere(0.5); }"), rounded, 1e-2 * rounded);
}

TEST(Minkowski, OfAnythingButConvexPartsIsThatOfTheConvexPartsItIsCutInto) {
    // An L, 2 thick, grown by a cube of 1: [0,5]x[0,3] with a bite of 2 x 1 (3 - 1 each side).
    const std::string l = "difference() { cube([4, 2, 2]); translate([1, 1, -1]) cube([9, 9, 9]); }";
    EXPECT_NEAR(volume_of("minkowski() { " + l + " cube(1); }"), (5 * 3 - 3 * 1) * 3, 1e-9);
    EXPECT_NEAR(volume_of("minkowski() { union() { cube([4, 1, 2]); cube([1, 2, 2]); } cube(1); }"), 36, 1e-9);
}

TEST(Minkowski, IsTheSameAtAnyPlaceButForThePlace) {
    EXPECT_NEAR(
        volume_of("translate([5, 0, 0]) minkowski() { translate([1, 0, 0]) cube(1); translate([0, 3, 0]) cube(1); }"),
        8, 1e-9);
}

TEST(Minkowski, OfOneChildIsTheChild) { EXPECT_EQ(tree_of(read("minkowski() { sphere(1); }")), "ball"); }

TEST(Minkowski, ThatWouldFillTheMemoryIsRefusedUnlessAllowed) {
    // Two sizes, because what was once worked out is not refused again.
    const auto sum = [](const std::string& radius) {
        const std::string dented = "difference() { sphere(" + radius + ", $fn = 8); cube(1); }";
        return "minkowski() { " + dented + dented + " }";
    };
    ReadOptions options;
    options.openscad_facets = true;
    options.settings = {{"minkowski", "1000"}};
    const std::string refusal = error_of(sum("1.25"), options);
    EXPECT_EQ(refusal.find("t.csg:1:1: minkowski()"), 0U) << refusal;
    EXPECT_NE(refusal.find("--set csg.minkowski="), std::string::npos) << refusal;
    options.settings = {{"minkowski", "1e6"}};
    EXPECT_EQ(error_of(sum("1"), options), "");
}

TEST(Minkowski, OfTwoBallsOfTenThousandFacetsIsDone) {
    ReadOptions options;
    options.openscad_facets = true;
    const Scene scene = read("minkowski() { sphere(1, $fn = 100); sphere(0.3, $fn = 100); }", options);
    ASSERT_EQ(scene.solids.meshes.size(), 1U);
    EXPECT_GE(scene.solids.meshes[0]->vertices.size(), 5000U);
}

TEST(Hull, OfAConvexSolidIsThatSolid) {
    EXPECT_EQ(tree_of(read("hull() { scale([1, 2, 3]) sphere(1); }")), "ball");
    std::string nested = "cube(1); translate([2, 0, 0]) cube(1);";
    for (int i = 0; i < 1000; ++i) nested = "hull() { " + nested + " }";
    const Scene scene = read(nested);
    EXPECT_EQ(scene.solids.meshes.size(), 1U);
}

TEST(Minkowski, OfPlaneFiguresIsTheirSum) {
    EXPECT_NEAR(area_of("minkowski() { square(2); square([1, 3]); }"), 15, 1e-6);
    EXPECT_NEAR(area_of("minkowski() { difference() { square(6); translate([2, 2]) square(2); } square(1); }"), 49 - 1,
                1e-6);
    EXPECT_NEAR(area_of("minkowski() { square(2); circle(1); }"), 4 + 8 + pi, 2e-3);
}

TEST(Minkowski, OfASolidWithACavityKeepsTheCavity) {
    const std::string shell = "difference() { cube(19, center = true); cube(11, center = true); }";
    EXPECT_NEAR(volume_of("minkowski() { " + shell + " cube(1, center = true); }"), 8000 - 1000, 1e-6);
    // A ball of the material within the cavity is there, too.
    EXPECT_NEAR(volume_of("minkowski() { union() { " + shell + " cube(1, center = true); } cube(1, center = true); }"),
                8000 - 1000 + 8, 1e-6);
}

TEST(Minkowski, LeavesOutWhatIsEmpty) {
    const std::string nothing = "intersection() { cube(1); translate([2, 0, 0]) cube(1); }";
    EXPECT_NEAR(volume_of("minkowski() { " + nothing + " cube(2); }"), 8, 1e-9);
    EXPECT_NEAR(volume_of("minkowski() { cube(1); " + nothing + " cube(2); }"), 27, 1e-9);
}

TEST(Booleans, OfCylindersWithOneRadiusEndAndLeaveNoSlivers) {
    constexpr double tolerance = 1e-2;  // CGAL's corefinement does not end here, and its Nef polyhedra are slow
    const double whole = volume_of("cylinder(h = 10, r = 1);", false, tolerance);
    for (const double h : {1.0, 9.75}) {
        const std::string cut = "cylinder(h = " + std::to_string(h) + ", r = 1); }";
        EXPECT_NEAR(volume_of("difference() { cylinder(h = 10, r = 1); " + cut, false, tolerance),
                    whole * (10 - h) / 10, 1e-9)
            << h;
    }
}

TEST(Resize, GivesTheSidesThatAreSaid) {
    EXPECT_NEAR(volume_of("resize([4, 0, 0]) cube(2);"), 16, 1e-12);
    EXPECT_NEAR(volume_of("resize(newsize = [4, 0, 0], auto = true) cube(2);"), 64, 1e-12);
    EXPECT_NEAR(volume_of("resize(newsize = [4, 0, 0], auto = [0, 1, 0]) cube(2);"), 32, 1e-12);
    EXPECT_EQ(tree_of(read("resize([4, 4, 4]) sphere(1);")), "ball");
    EXPECT_EQ(read("resize([4, 4, 4]) sphere(1);").solids.leaves[0].to_world, Affine::scaling({2, 2, 2}));
}

TEST(Resize, SeesWhatBooleansLeave) {
    EXPECT_NEAR(volume_of("resize([1, 0, 0]) difference() { cube(4); translate([2, -1, -1]) cube(9); }"), 16, 1e-9);
}

TEST(Resize, OfAPlaneFigureLeavesACircleACircle) {
    EXPECT_NEAR(area_of("resize([4, 6]) square(2);"), 24, 1e-9);
    EXPECT_EQ(tree_of(read("linear_extrude(1) resize([4, 4]) circle(1);")), "cone");
}

TEST(Projection, IsTheShadow) {
    EXPECT_NEAR(area_of("projection() cube([2, 3, 4]);"), 6, 1e-6);
    EXPECT_NEAR(area_of("projection() { cube(2); translate([1, 1, 5]) cube(2); }"), 7, 1e-6);
    // Chords within 1e-3 of the diagonal, half of that for each of a ball's two curvatures.
    const double chord = 1e-3 * 4 * std::sqrt(3.0) / 2;
    expect_area_within("projection() sphere(2);", 4 * pi, area_beside_chords(2, chord));
    // The hole goes through only where nothing stands in the light.
    EXPECT_NEAR(area_of("projection() difference() { cube(4); translate([1, 1, -1]) cube([2, 2, 9]); }"), 12, 1e-6);
    EXPECT_NEAR(area_of("projection() difference() { cube(4); translate([1, 1, 1]) cube([2, 2, 9]); }"), 16, 1e-6);
}

/// Edges of the shadow that almost coincide snap to the grid apart from each other.
TEST(Projection, LeavesNoSliversOfTheGrid) {
    const std::string coarse = ", $fa = 30, $fs = 2);";
    const std::string cone = "cylinder(h = 62.5, r1 = 12.5, r2 = 6.25, center = true" + coarse;
    ReadOptions options;
    options.openscad_facets = true;
    Scene scene = read("difference() { sphere(25" + coarse + cone + "rotate([90, 0, 0]) " + cone +
                           "multmatrix([[0, 0, 1], [0, 1, 0], [-1, 0, 0]]) " + cone + "}",
                       options);
    SolidTree& tree = scene.solids;
    const TriangleMesh mesh = csg::evaluate_mesh(tree, tree.add_node(SolidOp::unite, tree.roots), 0);
    EXPECT_LE(csg::shadow(mesh, 0x1p-16).contours.size(), 2U);
}

TEST(Projection, CutIsTheSectionAtZero) {
    EXPECT_NEAR(area_of("projection(cut = true) translate([0, 0, -1]) cube([2, 3, 4]);"), 6, 1e-6);
    const double chord = 1e-4 * std::sqrt(8.0 * 8 + 8 * 8 + 4 * 4) / 2;  // at half the height, of the diagonal
    expect_area_within("projection(cut = true) cylinder(h = 4, r1 = 4, r2 = 0, center = true);", 4 * pi,
                       area_beside_chords(2, chord));
    EXPECT_NEAR(area_of("projection(cut = true) difference() { translate([0, 0, -2]) cube(4); translate([1, 1, -5]) "
                        "cube([1, 1, 9]); }"),
                15, 1e-6);
    EXPECT_EQ(tree_of(read("cube(1); linear_extrude(1) projection(cut = true) translate([0, 0, 1]) cube(1);")), "box");
}

TEST(Projection, CutTakesFacesThatLieInThePlane) {
    EXPECT_NEAR(area_of("projection(cut = true) cube(2);"), 4, 1e-6);
    EXPECT_NEAR(area_of("projection(cut = true) translate([0, 0, -2]) cube(2);"), 4, 1e-6);
}

TEST(Offset, GrowsRoundMitredAndChamfered) {
    expect_area_within("offset(r = 1) square(4);", 16 + 16 + pi, area_beside_chords(1, 1e-4 * 5));
    EXPECT_NEAR(area_of("offset(delta = 1) square(4);"), 36, 1e-6);
    // A corner of the square of 36 is cut off at distance 1 from the old corner: legs of 2 - sqrt 2.
    const double leg = 2 - std::sqrt(2.0), chamfered = 36 - 4 * leg * leg / 2;
    EXPECT_NEAR(area_of("offset(delta = 1, chamfer = true) square(4);"), chamfered, 1e-3);
    EXPECT_NEAR(area_of("offset(r = -1) square(4);"), 4, 1e-6);
    EXPECT_EQ(tree_of(read("cube(1); linear_extrude(1) offset(r = -3) square(4);")), "box");
}

TEST(Offset, OfACircleIsACircle) { EXPECT_EQ(tree_of(read("linear_extrude(1) offset(r = 1) circle(3);")), "cone"); }

TEST(Offset, OfASolidIsRefusedOrLeftOut) {
    EXPECT_TRUE(
        contains(warnings_of(read("cube(1); linear_extrude(1) offset(r = 1) cube(1);")), "among plane figures"));
}

TEST(Fill, LeavesNoHoles) {
    EXPECT_NEAR(area_of("fill() difference() { square(6); translate([2, 2]) square(2); }"), 36, 1e-6);
}

TEST(Operations, KeepTheMaterialOfTheirFirstChild) {
    const Scene scene = read("hull() { color([1, 0, 0, 1]) cube(1); translate([2, 0, 0]) cube(1); }");
    EXPECT_NE(scene.solids.leaves[0].material, 0U);
}

TEST(Operations, InASubtrahendCut) {
    EXPECT_NEAR(volume_of("difference() { cube(4); hull() { cube(1); translate([1, 0, 0]) cube(1); } }"), 62, 1e-9);
}

/// The volume below the distance from the edge of an L of three squares of 2, by its value at 10^6 points.
double volume_below_the_distance() {
    constexpr int n = 1000;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double x = 4 * (i + 0.5) / n, y = 4 * (j + 0.5) / n;
            if (x > 2 && y > 2) continue;
            double least = std::min({x, y, 4 - x, 4 - y});
            if (x < 2) least = std::min(least, std::hypot(2 - x, std::min(y - 2, 0.0)));
            if (y < 2) least = std::min(least, std::hypot(std::min(x - 2, 0.0), 2 - y));
            sum += least;
        }
    return sum * 16 / (n * n);
}

TEST(Roof, StandsAsHighAsTheEdgeIsFar) {
    EXPECT_NEAR(volume_of("roof() square(2, center = true);"), 4.0 / 3, 1e-12);
    EXPECT_NEAR(volume_of("roof(method = \"straight\") square([2, 4]);"), 10.0 / 3, 1e-12);
    EXPECT_NEAR(volume_of("roof() circle(3, $fn = 6);"), 3 * std::sqrt(3.0) / 2 * 9 * 3 * std::sqrt(0.75) / 3, 1e-9);
    EXPECT_NEAR(volume_of("scale([1, 1, 3]) roof() translate([9, 0]) square(2);"), 4, 1e-12);
}

TEST(Roof, IsAConeAroundACornerThatTurnsInwards) {
    const std::string l = "{ square([4, 2]); square([2, 4]); }";
    EXPECT_NEAR(volume_of("roof(method = \"straight\") " + l), 16.0 / 3, 1e-9);
    const double wanted = volume_below_the_distance(), found = volume_of("roof() " + l);
    EXPECT_NEAR(found, wanted, 2e-4 * wanted);
    EXPECT_GT(found, 16.0 / 3 + 0.05);
}

TEST(Roof, GoesAroundHolesAndStandsOnIslands) {
    // A frame one wide: a ridge of height 1/2 around it. Its cross-section, 1/4, turns about the corners' inner sides.
    const std::string frame = "difference() { square(4, center = true); square(2, center = true); }";
    EXPECT_NEAR(volume_of("roof(method = \"straight\") " + frame), 3, 1e-9);
    const std::string island = "union() { " + frame + " square(1, center = true); }";
    EXPECT_NEAR(volume_of("roof(method = \"straight\") " + island), 3 + 1.0 / 6, 1e-9);
}

TEST(Roof, RefusesAMethodThatItDoesNotKnow) {
    EXPECT_TRUE(contains(error_of("\nroof(method = \"thatch\") square(1);"),
                         "t.csg:2:1: found \"thatch\", wanted roof(method = \"voronoi\") or \"straight\""));
    EXPECT_EQ(tree_of(read("cube(1); roof();")), "box");
}

}  // namespace

#include "formats/openscad/geometry/plane.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/language/read.hpp"

using namespace cardioid;
using cardioid::test::contains;
using cardioid::test::read;
using cardioid::test::tree_of;
using cardioid::test::warnings_of;

namespace {

double area(const Profile& profile) {
    double twice = 0;
    for (const auto& contour : profile.contours)
        for (std::size_t i = 0; i < contour.size(); ++i) twice += cross(contour[i], contour[(i + 1) % contour.size()]);
    return twice / 2;
}

/// The profile of a figure that makes a straight prism.
Profile profile_of(const std::string& figure, ReadOptions options = {}) {
    const Scene scene = read("linear_extrude(1) " + figure, options);
    return scene.solids.profiles.empty() ? Profile{} : *scene.solids.profiles[0];
}

}  // namespace

TEST(Plane, SquareAndPolygonKeepTheirPointsToTheLastBit) {
    EXPECT_EQ(profile_of("square(size = [0.1, 0.3], center = true);").contours[0][0], Vec2d(-0.05, -0.15));
    EXPECT_EQ(profile_of("polygon([[0.1, 0], [0.7, 0.3], [0, 1e-7]]);").contours[0][1], Vec2d(0.7, 0.3));
}

TEST(Plane, PolygonsAreTurnedCounterClockwiseAndHolesClockwise) {
    EXPECT_EQ(area(profile_of("polygon([[0, 0], [0, 1], [1, 0]]);")), 0.5);
    const Profile ring = profile_of(
        "polygon(points = [[0,0],[4,0],[4,4],[0,4],[1,1],[2,1],[2,2],[1,2]], paths = [[0,1,2,3],[4,5,6,7]]);");
    EXPECT_EQ(ring.contours.size(), 2U);
    EXPECT_EQ(area(ring), 15);
}

TEST(Plane, PathsMayBeUndefEmptyOrOneFlatList) {
    for (const char* paths : {"undef", "[]", "[[0, 1, 2]]", "[0, 1, 2]"})
        EXPECT_EQ(area(profile_of(std::string("polygon(points = [[0,0],[1,0],[0,1]], paths = ") + paths + ");")), 0.5);
}

TEST(Plane, SelfCrossingPolygonsAreEvenOdd) {
    const Profile bow = profile_of("polygon([[0, 0], [2, 2], [2, 0], [0, 2]]);");
    EXPECT_NEAR(area(bow), 2, 1e-9);
    const Profile twice = profile_of("polygon(points = [[0,0],[2,0],[2,2],[0,2]], paths = [[0,1,2,3],[0,1,2,3]]);");
    EXPECT_NEAR(area(twice), 0, 1e-9);
}

TEST(Plane, BooleansOfPlaneFigures) {
    EXPECT_NEAR(area(profile_of("difference() { square(4); translate([1, 1]) square(1); }")), 15, 1e-9);
    EXPECT_NEAR(area(profile_of("intersection() { square(4); translate([3, 3]) square(4); }")), 1, 1e-9);
    EXPECT_NEAR(area(profile_of("union() { square(4); translate([3, 3]) square(4); }")), 31, 1e-9);
    EXPECT_NEAR(area(profile_of("{ square(4); translate([3, 3]) square(4); }")), 31, 1e-9);
    EXPECT_TRUE(profile_of("difference() { square(1); square(2, center = true); }").empty());
    EXPECT_TRUE(profile_of("difference() { group(); square(2); }").empty());
}

TEST(Plane, BooleansOfTinyFiguresDoNotVanish) {
    const Profile tiny = profile_of("difference() { square(4e-9); square(1e-9); }");
    EXPECT_NEAR(area(tiny) / 15e-18, 1, 1e-9);
}

TEST(Plane, EmptyFiguresAreRemovedWithAWarning) {
    for (const char* figure :
         {"square(0);", "square([1, -1]);", "circle(0);", "circle(r = inf);", "polygon([]);",
          "polygon([[0, 0], [1, 1]]);", "polygon([[0, 0], [1, nan], [1, 1]]);",
          "polygon([[0, 0], [1, \"a\"], [1, 1]]);", "polygon(undef);", "scale([0, 1]) square(1);"}) {
        const Scene scene = read(std::string("linear_extrude(1) ") + figure);
        EXPECT_EQ(tree_of(scene), "") << figure;
        EXPECT_TRUE(contains(warnings_of(scene), "removed")) << figure;
    }
}

TEST(Plane, CollinearPolygonsEncloseNothing) { EXPECT_TRUE(profile_of("polygon([[0, 0], [1, 1], [2, 2]]);").empty()); }

TEST(Plane, FewFacetsOfACircleStay) {
    EXPECT_EQ(profile_of("circle(2, $fn = 6);").contours[0].size(), 6U);
    EXPECT_EQ(profile_of("circle(d = 2, $fn = 5);").contours[0][0], Vec2d(1, 0));
}

TEST(Plane, ATrueCircleInABooleanIsAFinePolygon) {
    const double error = 1 - std::cos(std::acos(-1) / formats::openscad::fine_circle);
    EXPECT_LT(error, 1e-4);
    const Scene scene = read("linear_extrude(1) difference() { circle(10); circle(5); }");
    EXPECT_EQ(tree_of(scene), "mesh");
}

TEST(Plane, AModelOfPlaneFiguresIsDrawnAsAPlate) {
    const Scene scene = read("square(2); translate([1, 1]) square(2);");
    EXPECT_EQ(tree_of(scene), "prism");
    EXPECT_EQ(scene.solids.leaves[0].to_world.point({0, 0, 0}).z, -0.5);
    EXPECT_TRUE(contains(warnings_of(scene), "plate"));
    EXPECT_EQ(tree_of(read("square(2); cube();")), "box");
}

TEST(Plane, OrientingSeesWhatIsNotSimple) {
    const auto orient = [](Profile profile) { return formats::openscad::orient_if_simple(profile); };
    EXPECT_TRUE(orient({{{{0, 0}, {1, 0}, {1, 1}}}}));
    EXPECT_FALSE(orient({{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}})) << "crosses itself";
    EXPECT_FALSE(orient({{{{0, 0}, {1, 0}, {1, 1}, {1, 0}}}})) << "folds back";
    EXPECT_FALSE(orient({{{{0, 0}, {1, 0}, {1, 0}, {1, 1}}}})) << "a corner twice";
    EXPECT_FALSE(orient({{{{0, 0}, {4, 0}, {4, 4}}, {{4, 2}, {5, 2}, {5, 3}}}})) << "contours touch";
}

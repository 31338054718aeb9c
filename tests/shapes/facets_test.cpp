#include "csg/shapes/facets.hpp"

#include <gtest/gtest.h>
#include <numbers>

#include "csg/shapes/degrees.hpp"
#include "csg/shapes/mesh_repair.hpp"

namespace {

using namespace cardioid;
using namespace cardioid::csg;

TEST(Degrees, AreExactAtMultiplesOfThirtyAndFortyFive) {
    EXPECT_EQ(sin_cos_deg(30).sin, 0.5);
    EXPECT_EQ(sin_cos_deg(60).cos, 0.5);
    EXPECT_EQ(sin_cos_deg(-60).sin, -sin_cos_deg(30).cos);
    EXPECT_EQ(sin_cos_deg(45).sin, sin_cos_deg(45).cos);
    EXPECT_EQ(sin_cos_deg(135).cos, -sin_cos_deg(45).cos);
    EXPECT_EQ(sin_cos_deg(330).sin, -0.5);
    for (const double turn : {-720.0, 0.0, 360.0, 3600000.0}) {
        EXPECT_EQ(sin_cos_deg(turn + 90).sin, 1);
        EXPECT_EQ(sin_cos_deg(turn + 90).cos, 0);
        EXPECT_EQ(sin_cos_deg(turn + 180).sin, 0);
        EXPECT_EQ(sin_cos_deg(turn + 270).sin, -1);
    }
}

TEST(Degrees, AgreeWithRadiansAndAreSymmetric) {
    for (int i = -4000; i <= 4000; ++i) {
        const double degrees = 0.173 * i, radians = degrees * std::numbers::pi / 180;
        EXPECT_NEAR(sin_cos_deg(degrees).sin, std::sin(radians), 2e-15);
        EXPECT_NEAR(sin_cos_deg(degrees).cos, std::cos(radians), 2e-15);
        EXPECT_EQ(sin_cos_deg(-degrees).sin, -sin_cos_deg(degrees).sin);
    }
    EXPECT_EQ(sin_cos_deg(20).sin, sin_cos_deg(160).sin);
    EXPECT_EQ(sin_cos_deg(20).sin, sin_cos_deg(70).cos);
}

TEST(FacetCount, IsOpenScads) {
    EXPECT_EQ(facet_count(1, {}), 5);
    EXPECT_EQ(facet_count(5, {}), 16);
    EXPECT_EQ(facet_count(1000, {}), 30);
    EXPECT_EQ(facet_count(5, {0, 1, 0.5}), 63);
    EXPECT_EQ(facet_count(5, {1}), 3);
    EXPECT_EQ(facet_count(5, {7.9}), 7);
    EXPECT_EQ(facet_count(5, {-3}), 16);
    EXPECT_EQ(facet_count(1e-7, {50}), 3);
    EXPECT_EQ(facet_count(5, {INFINITY}), 3);
    EXPECT_EQ(facet_count(5, {NAN}), 3);
    EXPECT_EQ(facet_count(5, {0, 0, 0}), 3142);  // $fa and $fs count as at least 0.01
    EXPECT_EQ(facet_count(NAN, {}), 3);
}

TEST(CirclePoints, OfASquareAndAHexagonAreExact) {
    EXPECT_EQ(circle_points(2, 4), (std::vector<Vec2d>{{2, 0}, {0, 2}, {-2, 0}, {0, -2}}));
    const auto hexagon = circle_points(2, 6);
    EXPECT_EQ(hexagon[1].x, 1);
    EXPECT_EQ(hexagon[2].x, -1);
    EXPECT_EQ(hexagon[1].y, -hexagon[5].y);
}

TEST(FacetedSolids, AreClosedAndTurnOutwards) {
    for (const int n : {3, 4, 5, 8, 30}) {
        for (TriangleMesh mesh : {faceted_sphere(2, n), faceted_cone(3, 2, 1, n), faceted_cone(3, 2, 0, n),
                                  faceted_cone(3, 0, 2, n), faceted_cone(1e-9, 1e9, 1e9, n)}) {
            EXPECT_TRUE(mesh.closed);
            const std::size_t corners = mesh.vertices.size();
            const MeshFaults faults = repair(mesh);
            EXPECT_TRUE(faults.closed());
            EXPECT_FALSE(faults.inside_out);
            EXPECT_EQ(faults.dropped_faces, 0U);
            EXPECT_EQ(mesh.vertices.size(), corners);
        }
    }
}

TEST(FacetedSolids, HaveTheirVolume) {
    EXPECT_NEAR(volume(faceted_cone(3, 2, 2, 4)), 3 * 8, 1e-12);
    EXPECT_NEAR(volume(faceted_cone(3, 2, 0, 4)), 8, 1e-12);
    EXPECT_NEAR(volume(faceted_cone(3, 0, 2, 4)), 8, 1e-12);
    EXPECT_NEAR(volume(faceted_sphere(1, 1000)), 4 * std::numbers::pi / 3, 1e-4);
}

TEST(FacetedSolids, ApproachTheRoundOnesWithTheSquareOfTheirFacets) {
    constexpr double ball = 4.0 / 3 * std::numbers::pi, rod = std::numbers::pi;
    for (int n = 16; n <= 128; n *= 2) {
        const double of_ball = (ball - volume(faceted_sphere(1, n))) / (ball - volume(faceted_sphere(1, 2 * n)));
        const double of_rod = (rod - volume(faceted_cone(1, 1, 1, n))) / (rod - volume(faceted_cone(1, 1, 1, 2 * n)));
        EXPECT_NEAR(of_ball, 4, 16.0 / n) << n;
        EXPECT_NEAR(of_rod, 4, 16.0 / n) << n;
    }
}

}  // namespace

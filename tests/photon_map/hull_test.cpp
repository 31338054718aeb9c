#include "photon/map/hull.hpp"

#include <gtest/gtest.h>
#include <vector>

#include "tests/photon_map/clouds.hpp"

namespace cardioid::photon::test {
namespace {

struct Points {
    std::vector<PlanePoint> points, room;
    explicit Points(const std::vector<Vec2>& places) : room(places.size() + 1) {
        for (std::uint32_t i = 0; i < places.size(); ++i) points.push_back({places[i].x, places[i].y, i});
    }
    Hull hull() { return convex_hull(points, room); }
};

TEST(Hull, OfASquareHasItsCornersAndArea) {
    Points p({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 0}, {0, 0}, {2, 1}});
    const Hull hull = p.hull();
    EXPECT_EQ(hull.corners.size(), 4U);
    EXPECT_EQ(hull.area, 4);
    EXPECT_EQ(hull.outside({1, 1}), -1);
    EXPECT_EQ(hull.outside({1, 2}), 0);
    EXPECT_EQ(hull.outside({1, 2.5F}), 0.5F);
}

TEST(Hull, OfPointsWithoutAreaIsNowhere) {
    for (const std::vector<Vec2>& places :
         {std::vector<Vec2>{}, {{1, 1}}, {{1, 1}, {1, 1}}, {{0, 0}, {1, 1}}, {{0, 0}, {1, 1}, {2, 2}, {3, 3}}}) {
        Points p(places);
        const Hull hull = p.hull();
        EXPECT_EQ(hull.area, 0);
        EXPECT_TRUE(std::isinf(hull.outside({0, 0})));
    }
}

/// Corners by definition: points that some line has on one side with all others, each tried against each.
std::size_t corners_by_force(const std::vector<Vec2>& p) {
    std::vector<bool> corner(p.size());
    for (std::size_t a = 0; a < p.size(); ++a)
        for (std::size_t b = 0; b < p.size(); ++b) {
            bool edge = a != b;
            for (std::size_t c = 0; c < p.size() && edge; ++c)
                edge = c == a || c == b || cross(p[b] - p[a], p[c] - p[a]) > 0;
            if (edge) corner[a] = corner[b] = true;
        }
    return static_cast<std::size_t>(std::count(corner.begin(), corner.end(), true));
}

TEST(Hull, HasTheCornersThatAreOutermost) {
    Random random;
    for (int round = 0; round < 200; ++round) {
        std::vector<Vec2> places(3 + random.below(40));
        for (Vec2& p : places) p = random.next2();
        Points p(places);
        const Hull hull = p.hull();
        EXPECT_EQ(hull.corners.size(), corners_by_force(places));
        for (const Vec2 inside : places) EXPECT_LE(hull.outside(inside), 1e-6F);
    }
}

}  // namespace
}  // namespace cardioid::photon::test

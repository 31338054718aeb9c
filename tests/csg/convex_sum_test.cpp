#include "csg/exact/minkowski/convex_sum.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "csg/exact/hull.hpp"
#include "csg/shapes/facets.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "tests/csg/models.hpp"

// Minkowski sums of convex solids against the hull of all sums of corners.
namespace cardioid::csg {
namespace {

using test::Random;

double volume_by_all_pairs(const ConvexPart& a, const ConvexPart& b) {
    std::vector<Vec3d> sums;
    for (const Vec3d p : a.corners())
        for (const Vec3d q : b.corners()) sums.push_back(p + q);
    return volume(convex_hull(sums));
}

void expect_right(const ConvexPart& a, const ConvexPart& b) {
    const double wanted = volume_by_all_pairs(a, b);
    EXPECT_NEAR(volume(convex_sum(a, b)), wanted, 1e-12 * wanted) << a.corners().size() << " " << b.corners().size();
}

std::vector<Vec3d> moved(std::vector<Vec3d> points, const Affine& by) {
    for (Vec3d& p : points) p = by.point(p);
    return points;
}

TEST(ConvexSum, IsTheHullOfAllSumsForRandomSolids) {
    Random random(1);
    for (int i = 0; i < 16; ++i) {
        const auto solid = [&](int n, Vec3d size) {
            std::vector<Vec3d> points;
            for (int k = 0; k < n; ++k) {
                const Vec3d d = random.direction();
                points.push_back({size.x * d.x, size.y * d.y, size.z * d.z});
            }
            return ConvexPart(points);
        };
        // Long against flat ones: their normals cross far from any corner.
        const double thin = i % 2 ? 1 : 1e-3;
        expect_right(solid(80, {10, thin, 1}), solid(random.whole(60, 300), {thin, 5, 1}));
    }
}

TEST(ConvexSum, OfSolidsWithFacesAndEdgesInCommonDirectionsIsRight) {
    const ConvexPart ball(faceted_sphere(1, 24).vertices), rod(faceted_cone(7, 2, 2, 96).vertices);
    expect_right(ball, ball);
    expect_right(rod, rod);
    expect_right(rod, ball);
    const double c = std::cos(0.1), s = std::sin(0.1);
    const ConvexPart turned(moved(ball.corners(), {{Vec3d{c, -s, 0}, {s, c, 0}, {0, 0, 1}}, {}}));
    expect_right(ball, turned);
    const ConvexPart far(moved(rod.corners(), Affine::translation({1e4, -3e4, 1e4})));
    expect_right(far, ball);
}

TEST(ConvexSum, OfALikeBallIsTheGreaterBall) {
    const ConvexPart small(faceted_sphere(0.3, 64).vertices), large(faceted_sphere(1, 64).vertices);
    const double wanted = volume(faceted_sphere(1.3, 64));
    const TriangleMesh sum = convex_sum(small, large);
    EXPECT_NEAR(volume(sum), wanted, 1e-11 * wanted);
    EXPECT_LT(sum_points(small, large), 1e5);  // of 4 million pairs
}

TEST(ConvexSum, OfAFlatPartIsTheSweptSolid) {
    const ConvexPart square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), box({{0, 0, 0}, {0, 0, 2}});
    EXPECT_TRUE(square.is_flat());
    EXPECT_NEAR(volume(convex_sum(square, box)), 2, 1e-15);
    EXPECT_TRUE(convex_sum(square, square).triangles.empty());
}

}  // namespace
}  // namespace cardioid::csg

#include "csg/shapes/extrude.hpp"

#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "csg/shapes/mesh_repair.hpp"
#include "csg/shapes/profile_boolean.hpp"
#include "rt_core/api/error.hpp"

namespace {

using namespace cardioid;
using namespace cardioid::csg;

Profile rectangle(double x0, double y0, double x1, double y1) { return {{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}}; }

/// Closed, turned outwards, nothing left to weld.
void expect_sound(const TriangleMesh& mesh) {
    EXPECT_TRUE(mesh.closed);
    TriangleMesh copy = mesh;
    const MeshFaults faults = repair(copy);
    EXPECT_TRUE(faults.closed());
    EXPECT_FALSE(faults.inside_out);
    EXPECT_EQ(faults.dropped_faces, 0U);
    EXPECT_EQ(copy.vertices.size(), mesh.vertices.size());
}

TEST(LinearExtrude, MakesPrismsPyramidsAndWedges) {
    const Profile base = rectangle(-1, -1, 1, 1);
    const TriangleMesh prism = linear_extrude(base, {.height = 3});
    expect_sound(prism);
    EXPECT_EQ(prism.vertices.size(), 8U);
    EXPECT_EQ(prism.triangles.size(), 12U);
    EXPECT_DOUBLE_EQ(volume(prism), 12);
    const TriangleMesh pyramid = linear_extrude(base, {.height = 3, .scale = {0, 0}});
    expect_sound(pyramid);
    EXPECT_EQ(pyramid.vertices.size(), 5U);
    EXPECT_DOUBLE_EQ(volume(pyramid), 4);
    const TriangleMesh wedge = linear_extrude(base, {.height = 3, .slices = 1, .scale = {0, 1}});
    expect_sound(wedge);
    EXPECT_EQ(wedge.vertices.size(), 6U);
    EXPECT_DOUBLE_EQ(volume(wedge), 6);
    const TriangleMesh frustum = linear_extrude(base, {.height = 3, .scale = {2, 2}});
    expect_sound(frustum);
    EXPECT_NEAR(volume(frustum), 28, 1e-12);
}

TEST(LinearExtrude, CentresWhenAsked) {
    for (const Vec3d p : linear_extrude(rectangle(0, 0, 1, 1), {.height = 3, .centre = true}).vertices)
        EXPECT_EQ(std::abs(p.z), 1.5);
}

TEST(LinearExtrude, TwistsClockwise) {
    const TriangleMesh mesh = linear_extrude(rectangle(1, 0, 2, 1), {.height = 1, .twist_deg = 90, .slices = 1});
    for (const Vec3d p : mesh.vertices)
        if (p.z == 1) {
            EXPECT_LE(p.y, -1);
        }
}

TEST(LinearExtrude, GivesNothingWithoutHeightOrProfile) {
    for (const double height : {0.0, -1.0, double(NAN), double(INFINITY)})
        EXPECT_TRUE(linear_extrude(rectangle(0, 0, 1, 1), {.height = height}).triangles.empty());
    EXPECT_TRUE(linear_extrude({}, {.height = 1}).triangles.empty());
    EXPECT_TRUE(linear_extrude(rectangle(0, 0, 0, 1), {.height = 1}).triangles.empty());
}

TEST(LinearExtrude, TakesANegativeScaleAsZero) {
    EXPECT_DOUBLE_EQ(volume(linear_extrude(rectangle(-1, -1, 1, 1), {.height = 3, .scale = {-1, -7}})), 4);
}

TEST(LinearExtrude, RefusesMoreCornersThanCanBeNumbered) {
    try {
        linear_extrude(rectangle(0, 0, 1, 1), {.height = 1, .twist_deg = 1, .slices = 2'000'000'000});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::limit);
    }
}

TEST(LinearExtrude, StaysClosedWhereContoursTouch) {
    const Profile corner{{rectangle(0, 0, 1, 1).contours[0], rectangle(1, 1, 2, 2).contours[0]}};
    const Profile on_edge{{rectangle(0, 0, 4, 4).contours[0], {{4, 1}, {6, 0}, {6, 2}}}};
    const Profile hole_at_border{{rectangle(0, 0, 4, 4).contours[0], {{4, 2}, {3, 1}, {3, 3}}}};
    const Profile along_edge{{rectangle(0, 0, 4, 4).contours[0], rectangle(4, 1, 6, 3).contours[0]}};
    const Profile bow{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}};
    const Profile wrong_way{{{{0, 0}, {0, 3}, {3, 3}, {3, 0}}, rectangle(1, 1, 2, 2).contours[0]}};
    const Profile collinear{{{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}}}};
    const double areas[] = {2, 18, 15, 20, 2, 8, 4};
    const double* expected = areas;
    for (const Profile& p : {corner, on_edge, hole_at_border, along_edge, bow, wrong_way, collinear}) {
        const TriangleMesh straight = linear_extrude(p, {.height = 2});
        EXPECT_TRUE(straight.closed);
        EXPECT_NEAR(volume(straight), 2 * *expected++, 1e-12);
        for (const Vec2d scale : {Vec2d{1, 1}, Vec2d{2, 0.5}, Vec2d{0, 1}, Vec2d{0, 0}})
            EXPECT_TRUE(linear_extrude(p, {.height = 2, .twist_deg = 100, .scale = scale}).closed);
    }
}

TEST(LinearExtrude, StaysClosedOnRandomFigures) {
    std::mt19937 rng(7);
    std::uniform_real_distribution<double> u(-5, 5);
    for (int round = 0; round < 60; ++round) {
        std::vector<Profile> parts(4);
        for (Profile& part : parts) {
            part.contours.emplace_back();
            for (int i = 0; i < 7; ++i) part.contours[0].push_back({u(rng), u(rng)});
        }
        const Profile figure = profile_boolean(round % 2 ? ProfileOp::unite : ProfileOp::subtract, parts, 0x1p-16);
        const TriangleMesh mesh = linear_extrude(figure, {.height = 2, .twist_deg = 30.0 * round, .scale = {1.2, 0.7}});
        EXPECT_TRUE(mesh.closed);
    }
}

TEST(LinearExtrude, DoesNotDependOnTheScaleOfTheModel) {
    const auto how = [](double s) { return LinearExtrusion{s, false, 200, 9, {1.5, 0.5}, {}}; };
    const double one = volume(linear_extrude(rectangle(1, 0, 2, 3), how(1)));
    const double thousand = volume(linear_extrude(rectangle(1000, 0, 2000, 3000), how(1000)));
    EXPECT_NEAR(thousand / 1e9 / one, 1, 1e-12);
}

TEST(SliceCount, IsOpenScads) {
    const Profile base = rectangle(0, 0, 10, 10);
    EXPECT_EQ(slice_count(base, {.height = 10}), 1);
    EXPECT_EQ(slice_count(base, {.height = 10, .scale = {3, 3}}), 1);
    EXPECT_EQ(slice_count(base, {.height = 10, .twist_deg = 90}), 8);
    EXPECT_EQ(slice_count(base, {.height = 10, .twist_deg = -90}), 8);
    EXPECT_EQ(slice_count(base, {.height = 10, .scale = {2, 1}}), 8);
    EXPECT_EQ(slice_count(base, {.height = 10, .twist_deg = 500, .facets = {3}}), 5);
    EXPECT_EQ(slice_count(base, {.height = 10, .twist_deg = 500, .facets = {INFINITY}}), 5);
    EXPECT_EQ(slice_count(base, {.height = 10, .twist_deg = 90, .slices = 3}), 3);
    EXPECT_EQ(slice_count(rectangle(0, 0, 1e-8, 1e-8), {.height = 10, .twist_deg = 90}), 1);
    EXPECT_GT(slice_count(base, {.height = 1e300, .twist_deg = 1e300}), 0);
}

TEST(RotateExtrude, OfAHalfDiscIsABall) {
    Profile half{{{}}};
    for (int k = -90; k <= 90; ++k)
        half.contours[0].push_back({std::cos(k * std::numbers::pi / 180), std::sin(k * std::numbers::pi / 180)});
    half.contours[0].front().x = half.contours[0].back().x = 0;
    const TriangleMesh ball = rotate_extrude(half, 360, {360});
    expect_sound(ball);
    EXPECT_NEAR(volume(ball), 4 * std::numbers::pi / 3, 1e-3);
}

TEST(RotateExtrude, StartsAtMinusXInFullAndAtPlusXInPart) {
    const Profile post = rectangle(2, 0, 3, 1);
    double least = 0, greatest = 0;
    for (const Vec3d p : rotate_extrude(post, 360, {5}).vertices) {
        least = std::min(least, p.x);
        greatest = std::max(greatest, p.x);
    }
    EXPECT_EQ(least, -3);
    EXPECT_LT(greatest, 2.9);
    for (const Vec3d p : rotate_extrude(post, 90, {}).vertices) EXPECT_TRUE(p.x >= 0 && p.y >= 0);
    for (const Vec3d p : rotate_extrude(post, -90, {}).vertices) EXPECT_TRUE(p.x >= 0 && p.y <= 0);
}

TEST(RotateExtrude, IsClosedAndTurnedOutwardsOnAllSidesAndAngles) {
    const Profile ring =
        profile_boolean(ProfileOp::subtract, std::vector{rectangle(2, -1, 6, 3), rectangle(3, 0, 4, 1)}, 0x1p-16);
    const Profile axis = rectangle(0, 0, 2, 1), tip{{{{0, 0}, {2, -1}, {2, 1}}}};
    for (const Profile& p : {ring, axis, tip})
        for (const double side : {1.0, -1.0})
            for (const double angle : {360.0, 300.0, 90.0, 1.0, -1.0, -90.0, -359.0}) {
                const Profile placed = transformed(p, Affine::scaling({side, 1, 1}));
                const TriangleMesh mesh = rotate_extrude(placed, angle, {24});
                expect_sound(mesh);
                EXPECT_GT(volume(mesh), 0);
            }
}

TEST(RotateExtrude, TakesOtherAnglesAsAFullTurnAndZeroAsNothing) {
    const Profile post = rectangle(2, 0, 3, 1);
    for (const double angle : {-360.0, 361.0, 1e9, double(NAN)})
        EXPECT_EQ(rotate_extrude(post, angle, {}).triangles, rotate_extrude(post, 360, {}).triangles);
    EXPECT_TRUE(rotate_extrude(post, 0, {}).triangles.empty());
    EXPECT_TRUE(rotate_extrude({}, 360, {}).triangles.empty());
}

TEST(RotateExtrude, RefusesAProfileOnBothSidesOfTheAxis) {
    EXPECT_THROW(rotate_extrude(rectangle(-1, 0, 3, 1), 360, {}), Error);
}

}  // namespace

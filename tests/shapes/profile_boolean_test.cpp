#include "csg/shapes/profile_boolean.hpp"

#include <gtest/gtest.h>
#include <random>

#include "csg/shapes/triangulate.hpp"
#include "rt_core/api/error.hpp"

namespace {

using namespace cardioid;
using namespace cardioid::csg;

constexpr double grid = 0x1p-16;

double signed_area(const std::vector<Vec2d>& contour) {
    double out = 0;
    for (std::size_t i = 0; i < contour.size(); ++i) out += cross(contour[i], contour[(i + 1) % contour.size()]) / 2;
    return out;
}
double area(const Profile& p) {
    double out = 0;
    for (const auto& contour : p.contours) out += signed_area(contour);
    return out;
}
Profile rectangle(double x0, double y0, double x1, double y1) { return {{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}}; }
Profile apply(ProfileOp op, std::vector<Profile> parts, double step = grid) { return profile_boolean(op, parts, step); }

TEST(ProfileBoolean, GivesTheAreasOfTwoSquares) {
    const Profile a = rectangle(0, 0, 2, 2), b = rectangle(1, 1, 3, 3);
    EXPECT_EQ(area(apply(ProfileOp::unite, {a, b})), 7);
    EXPECT_EQ(area(apply(ProfileOp::intersect, {a, b})), 1);
    EXPECT_EQ(area(apply(ProfileOp::subtract, {a, b})), 3);
    EXPECT_EQ(area(apply(ProfileOp::intersect, {a, b, rectangle(1.5, 0, 3, 3)})), 0.5);
    EXPECT_TRUE(apply(ProfileOp::intersect, {a, rectangle(5, 5, 6, 6)}).empty());
    EXPECT_TRUE(apply(ProfileOp::subtract, {a, rectangle(-1, -1, 6, 6)}).empty());
    EXPECT_TRUE(apply(ProfileOp::unite, {}).empty());
    EXPECT_TRUE(apply(ProfileOp::subtract, {{}, a}).empty());
    EXPECT_EQ(area(apply(ProfileOp::subtract, {a})), 4);
}

TEST(ProfileBoolean, TurnsOuterContoursLeftAndHolesRight) {
    Profile clockwise = rectangle(0, 0, 9, 9);
    std::ranges::reverse(clockwise.contours[0]);
    const Profile ring = apply(ProfileOp::subtract, {clockwise, rectangle(2, 2, 4, 4), rectangle(5, 5, 6, 6)});
    ASSERT_EQ(ring.contours.size(), 3U);
    int holes = 0;
    for (const auto& contour : ring.contours) holes += signed_area(contour) < 0;
    EXPECT_EQ(holes, 2);
    EXPECT_EQ(area(ring), 81 - 4 - 1);
}

TEST(ProfileBoolean, SanitisesByTheEvenOddRule) {
    const Profile nested{
        {rectangle(0, 0, 9, 9).contours[0], rectangle(1, 1, 8, 8).contours[0], rectangle(2, 2, 7, 7).contours[0]}};
    EXPECT_EQ(area(apply(ProfileOp::unite, {nested})), 81 - 49 + 25);
    const Profile bow{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}};
    EXPECT_EQ(area(apply(ProfileOp::unite, {bow})), 2);
    const Profile twice{{rectangle(0, 0, 1, 1).contours[0], rectangle(0, 0, 1, 1).contours[0]}};
    EXPECT_TRUE(apply(ProfileOp::unite, {twice}).empty());
}

TEST(ProfileBoolean, TruncatesToTheGrid) {
    const Profile out = apply(ProfileOp::unite, {rectangle(-0.00309017, -0.00309017, 0.00309017, 0.00309017)});
    for (const Vec2d p : out.contours.at(0)) {
        EXPECT_EQ(std::abs(p.x), 202 * grid);
        EXPECT_EQ(std::abs(p.y), 202 * grid);
    }
    const Profile again = apply(ProfileOp::unite, {out}, 1.9 * grid);  // taken down to a power of two
    EXPECT_EQ(area(again), area(out));
}

TEST(ProfileBoolean, TakesACoarserGridForHugeFigures) {
    for (const double size : {1e9, 1e14, 1e30, 1e150}) {
        const Profile out = apply(ProfileOp::subtract, {rectangle(0, 0, 2 * size, size), rectangle(0, 0, size, size)});
        EXPECT_NEAR(area(out) / size / size, 1, 1e-13) << size;
    }
}

TEST(ProfileBoolean, LeavesOutWhatIsNotFiniteOrHasNoArea) {
    EXPECT_EQ(area(apply(ProfileOp::unite, {rectangle(0, 0, 1, 1), rectangle(0, 0, NAN, 1)})), 1);
    EXPECT_EQ(area(apply(ProfileOp::unite, {rectangle(0, 0, 1, 1), rectangle(0, 0, INFINITY, 1)})), 1);
    EXPECT_TRUE(apply(ProfileOp::unite, {rectangle(0, 0, 0, 5)}).empty());
    EXPECT_TRUE(apply(ProfileOp::unite, {Profile{{{{1, 1}}, {}}}}).empty());
    EXPECT_TRUE(apply(ProfileOp::unite, {rectangle(0, 0, 0, 0)}, 0).empty());
}

/// Points a little off the grid lines, so that truncation cannot move a border across them.
TEST(ProfileBoolean, AgreesWithMembershipOnRandomFigures) {
    std::mt19937 rng(1);
    std::uniform_int_distribution<int> whole(-8, 8);
    for (int round = 0; round < 200; ++round) {
        std::vector<Profile> parts(3);
        for (Profile& part : parts)
            for (int c = 0; c < 2; ++c) {
                auto& contour = part.contours.emplace_back();
                for (int i = 0; i < 5; ++i)
                    contour.push_back({static_cast<double>(whole(rng)), static_cast<double>(whole(rng))});
            }
        const Profile sum = apply(ProfileOp::unite, parts), common = apply(ProfileOp::intersect, parts),
                      rest = apply(ProfileOp::subtract, parts);
        for (int i = 0; i < 100; ++i) {
            const Vec2d p{whole(rng) + 0.0371, whole(rng) + 0.0517};
            const bool a = contains(parts[0], p), b = contains(parts[1], p), c = contains(parts[2], p);
            EXPECT_EQ(contains(sum, p), a || b || c);
            EXPECT_EQ(contains(common, p), a && b && c);
            EXPECT_EQ(contains(rest, p), a && !b && !c);
        }
    }
}

TEST(Transformed, KeepsTheOrientationWhenMirrored) {
    const Affine mirror = Affine::translation({1, 2, 3}) * Affine::scaling({-2, 3, 1});
    const Profile out = transformed(rectangle(0, 0, 1, 1), mirror);
    EXPECT_EQ(area(out), 6);
    EXPECT_TRUE(contains(out, {0, 3}));
    EXPECT_FALSE(contains(out, {2, 3}));
}

TEST(Contains, CountsAPointOnACornerLineOnce) {
    const Profile diamond{{{{-1, 0}, {0, -1}, {1, 0}, {0, 1}}}};
    EXPECT_TRUE(contains(diamond, {0, 0}));
    EXPECT_FALSE(contains(diamond, {-5, 0}));
    EXPECT_FALSE(contains(diamond, {5, 0}));
    EXPECT_FALSE(contains(diamond, {0.5, 1}));
    EXPECT_FALSE(contains({}, {0, 0}));
    EXPECT_FALSE(contains(Profile{{{}}}, {0, 0}));
}

double filled_area(const FilledProfile& filled) {
    double out = 0;
    for (const auto& [a, b, c] : filled.triangles) {
        const double part = cross(filled.points[b] - filled.points[a], filled.points[c] - filled.points[a]) / 2;
        EXPECT_GT(part, 0);
        out += part;
    }
    return out;
}

TEST(Fill, CoversTheInsideWithTrianglesOfPositiveArea) {
    const Profile ring = apply(ProfileOp::subtract, {rectangle(0, 0, 9, 9), rectangle(2, 2, 4, 4)});
    const FilledProfile filled = fill(ring);
    EXPECT_EQ(filled.points.size(), 8U);
    EXPECT_EQ(filled.triangles.size(), 8U);
    EXPECT_EQ(filled_area(filled), area(ring));
}

TEST(Fill, CutsContoursWhereTheyTouchOrCross) {
    const Profile touching{{rectangle(0, 0, 4, 4).contours[0], {{4, 1}, {6, 2}, {6, 0}}}};
    const FilledProfile touched = fill(touching);
    EXPECT_EQ(filled_area(touched), 16 + 2);
    EXPECT_EQ(touched.contours[0].size(), 5U);
    const Profile bow{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}};
    const FilledProfile crossed = fill(bow);
    EXPECT_EQ(crossed.points.size(), 5U);
    EXPECT_EQ(filled_area(crossed), 2);
}

TEST(Fill, TakesFiguresWithoutArea) {
    EXPECT_TRUE(fill({}).triangles.empty());
    EXPECT_TRUE(fill(Profile{{{}, {{1, 1}}, {{1, 1}, {2, 2}}}}).triangles.empty());
    EXPECT_TRUE(fill(Profile{{{{0, 0}, {1, 1}, {2, 2}}}}).triangles.empty());
    EXPECT_TRUE(
        fill(Profile{{rectangle(0, 0, 1, 1).contours[0], rectangle(0, 0, 1, 1).contours[0]}}).triangles.empty());
}

}  // namespace

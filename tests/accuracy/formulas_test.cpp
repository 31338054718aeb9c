/// The table itself: whoever reads it finds sound scenes, and every expected value is found again by its formula.
#include "tests/accuracy/formulas/formulas.hpp"

#include <gtest/gtest.h>
#include <set>

#include "tests/accuracy/formulas/cube_radiosity.hpp"
#include "tests/accuracy/lit_scene.hpp"
#include "tests/accuracy/table.hpp"

namespace cardioid::test {
namespace {

TEST(ExpectedValues, FollowFromTheirFormulas) {
    for (const KnownValue& known : known_values()) {
        const double found = known_formula(known.formula, known.args) * known.times;
        EXPECT_NEAR(found, known.expected, 2e-5 * std::abs(known.expected)) << known.title();
    }
}

TEST(ExpectedValues, HaveNamesOfTheirOwn) {
    std::set<std::string> titles;
    for (const KnownValue& known : known_values()) EXPECT_TRUE(titles.insert(known.title()).second) << known.title();
}

TEST(ExpectedValues, BelongToScenesThatHaveThoseParameters) {
    for (const KnownValue& known : known_values())
        EXPECT_NO_THROW(sample_scene("accuracy/" + known.scene, known.change)) << known.title();
    EXPECT_THROW(sample_scene("accuracy/rooms/cube.csg", {{"no such text", ""}}), Error);
}

TEST(CubeRadiosity, SeesAllOfTheCubeAndKeepsEnergy) {
    // Where all faces shine alike, E = M / (1 - rho) everywhere.
    const CubeRadiosity cube(6);
    const std::vector<double> radiosity = cube.solve({0.8, 0.8, 0.8, 0.8, 0.8, 0.8}, {1, 1, 1, 1, 1, 1}, 0);
    EXPECT_NEAR(cube.irradiance(radiosity, 0, 2, {0, 0.3, 0.9}), 5, 1e-7);
}

TEST(CubeRadiosity, HasTheDirectLightOfAPointSourceExactly) {
    const CubeRadiosity cube(2);
    EXPECT_NEAR(cube.irradiance(cube.solve({}, {}, 96), 96, 0, {0.5, 0.5, 0}), 1.90985931710 * 16, 1e-8);
}

TEST(CieSkies, HaveTheIntegralsOfTheStandardsFormula) {
    // Published for the sun 60 degrees over the horizon, to 5 decimals.
    const std::pair<double, double> known[] = {{1, 7.31516}, {5, 3.14159}, {8, 7.74527}, {12, 2.90647}, {15, 2.67057}};
    for (const auto& [type, value] : known)
        EXPECT_NEAR(known_formula("cie_sky_undivided", std::vector<double>{type, 60}), value, 3e-5) << type;
}

/// Mean irradiance of the floor within a square, by counting the rays of a beam of irradiance 1 that come down at 45
/// degrees on a mirrored half ring of radius 1 and height 2; `most` reflections.
double counted_in_ring(Vec2d lo, double edge, int most) {
    constexpr int rays = 1500;
    int there = 0;
    for (int i = 0; i < rays * rays; ++i) {
        double y = 2 * (i / rays + 0.5) / rays - 1, x = std::sqrt(1 - y * y), dx = 1, dy = 0;
        double height = 2 * (i % rays + 0.5) / rays;
        for (int k = 1; k <= most && x > 0; ++k) {
            const double away = 2 * (dx * x + dy * y);
            dx -= away * x, dy -= away * y;
            const double px = x + dx * height - lo.x, py = y + dy * height - lo.y;
            if (height <= away || x + dx * away < 0) {
                there += px > 0 && px < edge && py > 0 && py < edge;
                break;
            }
            x += dx * away, y += dy * away, height -= away;
        }
    }
    return there * 4 * std::sqrt(0.5) / (rays * static_cast<double>(rays)) / (edge * edge);
}

TEST(RingMirror, HasLightOfSeveralReflectionsCloseToTheRing) {
    constexpr double edge = 0.04;
    constexpr int cells = 8;
    for (const Vec2d lo : {Vec2d{0.78, 0.4}, {0.58, 0.72}, {0.86, 0.24}, {0.3, 0.1}}) {
        double mean = 0;
        for (int i = 0; i < cells * cells; ++i) {
            const double x = lo.x + edge * (i / cells + 0.5) / cells, y = lo.y + edge * (i % cells + 0.5) / cells;
            mean += known_formula("ring_mirror", std::vector<double>{x, y, 0}) / (cells * cells);
        }
        const double direct = std::sqrt(0.5), counted = counted_in_ring(lo, edge, 24);
        EXPECT_NEAR(mean - direct, counted, 0.02 * counted) << lo.x;
        // The first reflection alone would not do where there is a second.
        if (std::hypot(lo.x, lo.y) > 0.8) {
            EXPECT_LT(counted_in_ring(lo, edge, 1), 0.8 * counted);
        }
    }
}

}  // namespace
}  // namespace cardioid::test

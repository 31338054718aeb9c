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

}  // namespace
}  // namespace cardioid::test

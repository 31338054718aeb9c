#include "shaders/lights/cie_sky.hpp"

#include <gtest/gtest.h>

#include "make.hpp"

namespace cardioid::test {
namespace {

using shaders::CieSky;

constexpr double degree = std::numbers::pi / 180;

Vec3d at(double elevation, double azimuth) {
    return {std::cos(elevation * degree) * std::cos(azimuth * degree),
            std::cos(elevation * degree) * std::sin(azimuth * degree), std::sin(elevation * degree)};
}

TEST(CieSky, IsOneAtTheZenithAndBlackBelowTheHorizon) {
    for (int type = 1; type <= 15; ++type) {
        const CieSky sky(type, 33 * degree);
        EXPECT_NEAR(sky.relative({0, 0, 2}), 1, 1e-12) << type;
        EXPECT_EQ(sky.relative({1, 0, -1e-6}), 0) << type;
        for (int azimuth = 0; azimuth < 360; azimuth += 5)
            for (int elevation = 1; elevation < 90; ++elevation)
                ASSERT_GT(sky.relative(at(elevation, azimuth)), 0) << type << " " << azimuth << " " << elevation;
    }
}

TEST(CieSky, OfTypeFiveIsEvenAndOfTypeOneThreeTimesBrighterAbove) {
    EXPECT_NEAR(CieSky(5, 1).relative(at(3, 77)), 1, 1e-12);
    EXPECT_NEAR(CieSky(5, 1).integral(), 2 * std::numbers::pi, 1e-3);
    EXPECT_NEAR(1 / CieSky(1, 1).relative(at(1e-9, 10)), 1 + 4 * std::exp(-0.7), 1e-12);
    // Irradiance of the ground as under the older overcast sky, (1 + 2 sin) / 3 (Moon and Spencer 1942): 7 pi / 9.
    const CieSky overcast(1, 1);
    double sum = 0;
    for (int i = 0; i < 1000; ++i) {
        const double sine2 = (i + 0.5) / 1000;
        sum += std::numbers::pi * overcast.relative({std::sqrt(1 - sine2), 0, std::sqrt(sine2)}) / 1000;
    }
    EXPECT_NEAR(sum, 7 * std::numbers::pi / 9, 0.004 * sum);
}

TEST(CieSky, IsBrightestAroundTheSun) {
    for (const int type : {8, 12, 13, 15}) {
        const CieSky sky(type, 40 * degree);
        const double sun = sky.relative(at(40, 0));
        EXPECT_GT(sun, 1.5 * sky.relative(at(40, 30))) << type;
        EXPECT_GT(sun, 4 * sky.relative(at(40, 90))) << type;
        EXPECT_NEAR(sky.relative(at(20, 50)), sky.relative(at(20, -50)), 1e-12) << type;
    }
}

TEST(CieSky, TurnsWithItsRotation) {
    const auto light = make_light("sky", {{"cie", number(12)}, {"elevation", number(40)}, {"rotation", number(90)}});
    const CieSky sky(12, 40 * degree);
    EXPECT_NEAR(double{light->escaped(Vec3(at(40, 90))).g}, sky.relative(at(40, 0)), 1e-4);
    EXPECT_NEAR(double{light->escaped(Vec3(at(30, 200))).g}, sky.relative(at(30, 110)), 1e-4);
}

}  // namespace
}  // namespace cardioid::test

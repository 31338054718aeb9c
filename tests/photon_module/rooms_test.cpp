#include <gtest/gtest.h>
#include <sstream>

#include "tests/photon_module/lit_scenes.hpp"

namespace cardioid::test {
namespace {

/// Two bays side by side, open to the front, with a wall of 12 between them; the lamp is in the right one.
const std::string bays = R"(define_material("plaster", kind = "diffuse", reflectance = 0.7);
material("plaster") difference() {
    translate([-140, 0, -20]) cube([280, 140, 170]);
    translate([-128, -1, 0]) cube([120, 121, 132]);
    translate([4, -1, 0]) cube([120, 121, 132]);
}
translate([60, 70, 92]) sphere_light(9, radiance = 20);
)";
const std::string dark = "-60 120 60 0 -1 0\n-20 120 10 0 -1 0\n-68 60 0 0 0 1\n-8 60 60 -1 0 0\n";
const std::string lit = "60 120 60 0 -1 0\n20 120 10 0 -1 0\n4 60 30 1 0 0\n";

/// Red irradiance at the points, one a line.
std::vector<double> irradiance(const std::string& points, const std::vector<std::string>& light) {
    const Folder folder;
    folder.write("bays.csg", bays);
    folder.write("points", points);
    std::vector<std::string> words{"probe", "bays.csg", "--points", "points"};
    words.insert(words.end(), light.begin(), light.end());
    const Outcome run = folder.call(words);
    EXPECT_EQ(run.status, 0) << run.err;
    std::vector<double> found;
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);) found.push_back(std::stod(line));
    return found;
}

TEST(Rooms, NextDoorToALampStayDark) {
    for (const char* how : {"gather", "cache", "map"}) {
        const auto E = irradiance(dark, {"--photons", "--spp", "64", "--set", std::string("photon.indirect=") + how});
        EXPECT_EQ(E, std::vector<double>(4, 0.0)) << how;
    }
}

TEST(Rooms, WithTheLampAreAsBrightAsPathsSay) {
    const auto paths = irradiance(lit, {"--noise", "0.7%"}),
               photons = irradiance(lit, {"--photons", "--noise", "0.7%"});
    ASSERT_EQ(paths.size(), 3U);
    ASSERT_EQ(photons.size(), 3U);
    for (std::size_t i = 0; i < paths.size(); ++i) EXPECT_NEAR(photons[i] / paths[i], 1, 0.035) << i;
}

}  // namespace
}  // namespace cardioid::test

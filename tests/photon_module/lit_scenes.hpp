#pragma once
#include <string>
#include <vector>

#include "tests/cli/program.hpp"

namespace cardioid::test {

/// A corner with a glass ball, a mirror and a lamp: direct, indirect and caustic light all take part.
inline const std::string lit_room = R"(
camera([40, -90, 50], look_at = [0, 0, 8], fov = 40);
define_material("white", kind = "diffuse", reflectance = [0.7, 0.7, 0.7]);
define_material("red", kind = "diffuse", reflectance = [0.7, 0.1, 0.1]);
define_material("glass", kind = "dielectric", ior = 1.5);
define_material("silver", kind = "mirror");
material("white") translate([-30, -30, -2]) cube([60, 60, 2]);
material("red") translate([-32, -30, 0]) cube([2, 60, 40]);
material("white") translate([-30, 30, 0]) cube([60, 2, 40]);
material("glass") translate([8, -8, 9]) sphere(8);
material("silver") translate([-12, 8, 0]) cube([10, 10, 20]);
translate([0, 0, 60]) rotate([0, 0, 0]) area_light([12, 12], radiance = [40, 38, 30]);
)";

/// Words of a quick picture of it with photons.
inline std::vector<std::string> photon_words(const std::string& scene, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{
        scene,   "--photons=3000",           "-s", "40x32", "--spp", "2", "--set", "photon.hemisphere=6,18",
        "--set", "photon.caustic_count=3000"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

}  // namespace cardioid::test

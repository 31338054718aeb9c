#include <gtest/gtest.h>

#include "formats/openscad/openscad_format.hpp"
#include "rt_core/plugin/registry.hpp"
#include "rt_core/scene/scene.hpp"
#include "shaders/builtins.hpp"
#include "tests/fuzz/mutate.hpp"
#include "tests/text_file.hpp"

namespace cardioid::formats {
namespace {

/// Damages of a .csg text.
void survive_scene(const std::string& sample, unsigned seed) {
    const std::unique_ptr<Registry> registry = make_registry();
    shaders::add_builtins(*registry);
    ReadOptions options;
    options.registry = registry.get();
    options.settings = {{"triangles", "100000"}};  // so that no more than the bound of memory is asked for
    const auto read = [&](const std::string& text) {
        return csg_format.read(text, "model.csg", options).solids.leaves.size();
    };
    EXPECT_GT(read(sample), 0U);
    test::survive(sample, seed, [&](const std::string& text) { static_cast<void>(read(text)); });
}

TEST(DamagedScenes, OfSolidsAreReadOrRefused) {
    survive_scene(
        "difference() { cube([4, 5, 6], center = true); translate([1, 0, 0]) sphere(r = 2, $fn = 8); }\n"
        "multmatrix([[1, 0, 0, 3], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) cylinder(h = 2, r1 = 1, r2 = 0.5);\n"
        "polyhedron(points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], faces = [[0, 1, 2], [0, 3, 1], [1, 3, 2], "
        "[2, 3, 0]]); color([1, 0, 0, 0.5]) render() intersection() { torus(5, 1); ellipsoid([1, 2, 3]); }\n",
        41);
}

TEST(DamagedScenes, OfPlaneFiguresAreReadOrRefused) {
    survive_scene(
        "linear_extrude(height = 5, twist = 30, scale = [1, 2], slices = 4) { difference() { square([4, 5]); "
        "circle(r = 1, $fn = 6); polygon(points = [[0, 0], [1, 0], [0, 1]], paths = [[0, 1, 2]]); } }\n"
        "rotate_extrude(angle = 90, $fn = 8) translate([5, 0]) offset(r = 0.2, $fn = 8) circle(r = 1, $fn = 5);\n"
        "linear_extrude(2) offset(delta = -0.2, chamfer = true) fill() resize([3, 0], auto = true) square(2);\n"
        "roof() square([3, 2]);\n",
        42);
}

TEST(DamagedScenes, OfMaterialsAndCamerasAreReadOrRefused) {
    survive_scene(test::file_text(CARDIOID_SOURCE_DIR "/samples/glass.csg"), 43);
    survive_scene(test::file_text(CARDIOID_SOURCE_DIR "/samples/lamps.csg"), 44);
}

TEST(DamagedScenes, OfWhatNeedsMeshesAreReadOrRefused) {
    survive_scene(
        "hull() { cube(2); translate([3, 0, 0]) sphere(r = 1, $fn = 5); }\n"
        "minkowski() { cube([1, 2, 3]); cylinder(h = 1, r = 1, $fn = 4); }\n"
        "linear_extrude(1) projection(cut = true) rotate([10, 20, 0]) cube(3, center = true);\n",
        45);
}

}  // namespace
}  // namespace cardioid::formats

#include <gtest/gtest.h>

#include "formats/brlcad/brlcad_format.hpp"
#include "formats/openscad/openscad_format.hpp"
#include "rt_core/plugin/registry.hpp"
#include "rt_core/scene/scene.hpp"
#include "tests/brlcad/database_writer.hpp"
#include "tests/brlcad/primitive_models.hpp"
#include "tests/fuzz/mutate.hpp"

namespace cardioid::formats {
namespace {

using test::survive;

TEST(DamagedFiles, OfDatabasesAreReadOrRefused) {
    const auto read = [](const std::string& text) { static_cast<void>(brlcad_format.read(text, "model", {})); };
    survive(test::small_binary(), 1, read);
    survive(test::small_text_v4(), 2, read);
    survive(test::small_text_v5(), 3, read);
}

TEST(DamagedFiles, OfSolidsWithCountsAreReadOrRefused) {
    const auto read = [](const std::string& text) {
        return brlcad_format.read(text, "model", {}).solids.leaves.size();
    };
    unsigned seed = 5;
    for (const std::string& sample : {test::counted_solids(), test::counted_solids_v4(), test::counted_solids_v5()}) {
        EXPECT_GE(read(sample), 5U);
        survive(sample, seed++, [&](const std::string& text) { static_cast<void>(read(text)); });
    }
}

TEST(DamagedFiles, OfScenesAreReadOrRefused) {
    const std::unique_ptr<Registry> registry = make_registry();
    ReadOptions options;
    options.registry = registry.get();
    const std::string sample =
        "difference() { cube([4, 5, 6], center = true); translate([1, 0, 0]) sphere(r = 2, $fn = 8); }\n"
        "multmatrix([[1, 0, 0, 3], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) cylinder(h = 2, r1 = 1, r2 = 0.5);\n"
        "polyhedron(points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], faces = [[0, 1, 2], [0, 3, 1], [1, 3, 2], "
        "[2, 3, 0]]);\n";
    survive(sample, 4,
            [&](const std::string& text) { static_cast<void>(csg_format.read(text, "model.csg", options)); });
}

}  // namespace
}  // namespace cardioid::formats

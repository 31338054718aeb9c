#include <gtest/gtest.h>

#include "formats/brlcad/brlcad_format.hpp"
#include "formats/brlcad/view/view_script.hpp"
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

TEST(DamagedFiles, OfViewScriptsAreReadOrRefused) {
    const auto read = [](const std::string& text) {
        Scene scene;
        brlcad::apply_view(brlcad::read_view(text, "view.rt"), scene);
        return scene.cameras.size();
    };
    unsigned seed = 8;
    for (const char* const sample :
         {"viewsize 10; # across\neye_pt 1 2 3; lookat_pt 0 0 0; set perspective=40 width=64; opt -s 32 -p60;\n"
          "start 0; clean; end;\nstart 1; ae 35 25; end;\n",
          "viewsize 10;\neye_pt 1 2 3;\nviewrot 0 1 0 0 0 0 1 0 1 0 0 0 0 0 0 1;\norientation 0 0 .6 .8;\nend;\n",
          "10\n1 2 3\n0 1 0 0\n0 0 1 0\n1 0 0 0\n0 0 0 1\n"}) {
        EXPECT_EQ(read(sample), 1U);
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

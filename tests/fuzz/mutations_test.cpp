#include <gtest/gtest.h>

#include "formats/brlcad/brlcad_format.hpp"
#include "formats/brlcad/view/view_script.hpp"
#include "rt_core/scene/scene.hpp"
#include "tests/brlcad/database_writer.hpp"
#include "tests/brlcad/primitive_models.hpp"
#include "tests/fuzz/mutate.hpp"
#include "tests/text_file.hpp"

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

TEST(DamagedFiles, OfEveryPrimitiveAreReadOrRefused) {
    const std::string sample = test::file_text(CARDIOID_SOURCE_DIR "/samples/brlcad/pieces.asc");
    const auto read = [](const std::string& text) {
        return brlcad_format.read(text, "model", {}).solids.leaves.size();
    };
    EXPECT_GE(read(sample), 16U);
    survive(sample, 11, [&](const std::string& text) { static_cast<void>(read(text)); });
}

TEST(DamagedFiles, OfViewScriptsAreReadOrRefused) {
    const auto read = [](const std::string& text) {
        Scene scene;
        brlcad::apply_views(brlcad::read_views(text, "view.rt"), scene);
        return scene.cameras.size();
    };
    unsigned seed = 8;
    for (const char* const sample :
         {"viewsize 10; # across\neye_pt 1 2 3; lookat_pt 0 0 0; set perspective=40 width=64; opt -s 32 -p60;\n"
          "start 0; clean; end;\nstart 1; ae 35 25; end;\n",
          "viewsize 10;\neye_pt 1 2 3;\nviewrot 0 1 0 0 0 0 1 0 1 0 0 0 0 0 0 1;\norientation 0 0 .6 .8;\nend;\n",
          "10\n1 2 3\n0 1 0 0\n0 0 1 0\n1 0 0 0\n0 0 0 1\n"}) {
        EXPECT_GT(read(sample), 0U);
        survive(sample, seed++, [&](const std::string& text) { static_cast<void>(read(text)); });
    }
}

}  // namespace
}  // namespace cardioid::formats

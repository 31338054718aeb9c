#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"
#include "tests/models/corpus.hpp"

// The program on the programs of OpenSCAD's packages, as a user calls it.
namespace {

namespace fs = std::filesystem;
using namespace cardioid::test;

/// Tries all of these: what needs nothing that is to come is drawn, the rest refused by name; returns how many were
/// drawn.
int draw_all(const std::vector<fs::path>& programs, const std::vector<std::string>& options) {
    const Folder folder;
    int drawn = 0;
    for (const fs::path& program : programs) {
        const auto csg = evaluated(program, ".csg");
        std::vector<std::string> words{csg ? csg->string() : program.string(),
                                       "--base-dir",
                                       program.parent_path().string(),
                                       "-o",
                                       "picture.png",
                                       "--progress",
                                       "none"};
        words.insert(words.end(), options.begin(), options.end());
        const Outcome outcome = folder.cardioid(words);
        const std::vector<std::string> missing = csg ? nodes_to_come(file_text(*csg)) : std::vector<std::string>{};
        if (csg && missing.empty()) {
            EXPECT_EQ(outcome.status, 0) << program << ": " << outcome.err;
            EXPECT_TRUE(folder.has("picture.png")) << program;
            ++drawn;
        } else {
            EXPECT_EQ(outcome.status, 3) << program << ": " << outcome.err;
            EXPECT_FALSE(folder.has("picture.png")) << program;
            const bool named = std::ranges::any_of(missing, [&](const std::string& node) {
                return outcome.err.find(node.substr(0, node.find(' '))) != std::string::npos;
            });
            EXPECT_TRUE(missing.empty() || named) << program << ": " << outcome.err;
        }
        fs::remove(folder.path("picture.png"));
    }
    fmt::print("{} of {} were drawn\n", drawn, programs.size());
    return drawn;
}

}  // namespace

TEST(Examples, AreDrawnOrNameTheNodeThatIsMissing) {
    if (!has_openscad()) GTEST_SKIP() << "openscad is not installed";
    const std::vector<fs::path> programs = programs_below("examples");
    if (programs.empty()) GTEST_SKIP() << "openscad's examples are not installed";
    EXPECT_GT(draw_all(programs, {"-s", "160x120", "--spp", "4"}), 20);
}

TEST(Examples, OfTheTestDataAreDrawnOrRefused) {
    if (!long_tests()) GTEST_SKIP() << "takes minutes: set CARDIOID_LONG_TESTS=1";
    if (!has_openscad()) GTEST_SKIP() << "openscad is not installed";
    const Folder folder;
    int drawn = 0, refused = 0, without_mesh = 0;
    for (const fs::path& program : programs_below("testdata")) {
        const auto csg = evaluated(program, ".csg");
        if (!csg) continue;
        const Outcome outcome = folder.cardioid({csg->string(), "--base-dir", program.parent_path().string(), "-o",
                                                 "picture.png", "-s", "64x48", "--spp", "1", "--progress", "none"});
        // Some import a mesh that was left out of the package.
        const bool no_mesh =
            outcome.status == 4 && outcome.err.find(".stl: cannot read it: No such") != std::string::npos;
        EXPECT_TRUE(outcome.status == 0 || outcome.status == 3 || no_mesh) << program << ": " << outcome.err;
        ++(outcome.status == 0 ? drawn : no_mesh ? without_mesh : refused);
    }
    fmt::print("{} drawn, {} refused, {} import what is not there\n", drawn, refused, without_mesh);
}

#include "tests/arch/include_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cardioid::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Complaints about a source at `path` with the one include line `line`.
std::vector<std::string> complaints(const std::string& path, const std::string& line) {
    return include_complaints(parse_source(path, "\n" + line + "\n"));
}

TEST(IncludeRules, AreKeptByEverySource) {
    const std::vector<Source> sources = read_tree(CARDIOID_SOURCE_DIR);
    ASSERT_GT(sources.size(), 50U) << "the tree is not where the test looks for it";
    for (const Source& source : sources) EXPECT_THAT(include_complaints(source), IsEmpty());
}

TEST(IncludeRules, NameAFileThatExists) {
    const std::filesystem::path top = CARDIOID_SOURCE_DIR;
    for (const Source& source : read_tree(top)) {
        for (const Include& include : source.includes) {
            const std::filesystem::path beside = (top / source.path).parent_path() / include.path;
            const bool found =
                !include.quoted || std::filesystem::exists(top / include.path) || std::filesystem::exists(beside);
            EXPECT_TRUE(found) << source.path << ":" << include.line << ": " << include.path;
        }
    }
}

TEST(IncludeRules, LetAShaderSeeTheHooksAlone) {
    EXPECT_THAT(complaints("shaders/phong.cpp", "#include \"rt_core/api/shader.hpp\""), IsEmpty());
    EXPECT_THAT(complaints("shaders/phong.cpp", "#include \"shaders/lobe.hpp\""), IsEmpty());
    EXPECT_THAT(complaints("shaders/phong.cpp", "#include \"rt_core/trace/tracer.hpp\""),
                ElementsAre("shaders/phong.cpp:2: shaders/ may not include \"rt_core/trace/tracer.hpp\""));
    EXPECT_THAT(complaints("shaders/phong.cpp", "#include \"csg/compile.hpp\""), ElementsAre(HasSubstr("may not")));
}

TEST(IncludeRules, LetThePhotonModuleSeeTheHooksAlone) {
    EXPECT_THAT(complaints("photon/photon_map.cpp", "#include \"rt_core/api/lighting.hpp\""), IsEmpty());
    for (const char* forbidden : {"rt_core/render/renderer.hpp", "rt_core/math/vec.hpp", "shaders/phong.hpp"})
        EXPECT_THAT(complaints("photon/photon_map.cpp", "#include \"" + std::string(forbidden) + "\""),
                    ElementsAre(HasSubstr(forbidden)));
}

TEST(IncludeRules, LetNothingInTheCoreSeeWhatIsAboveIt) {
    for (const char* above : {"csg/compile.hpp", "shaders/phong.hpp", "formats/mesh/mesh_file.hpp", "cli/options.hpp"})
        EXPECT_THAT(complaints("rt_core/render/tiles.cpp", "#include \"" + std::string(above) + "\""),
                    ElementsAre(HasSubstr("may not")));
    EXPECT_THAT(complaints("rt_core/api/world.hpp", "#include \"rt_core/scene/scene.hpp\""),
                ElementsAre(HasSubstr("may not")));
    EXPECT_THAT(complaints("rt_core/math/vec.hpp", "#include \"rt_core/api/error.hpp\""),
                ElementsAre(HasSubstr("may not")));
}

TEST(IncludeRules, LetSolidsSeeTheRegionButNotTheTracer) {
    EXPECT_THAT(complaints("csg/compile.cpp", "#include \"rt_core/trace/region.hpp\""), IsEmpty());
    EXPECT_THAT(complaints("csg/compile.cpp", "#include \"rt_core/trace/tracer.hpp\""),
                ElementsAre(HasSubstr("may not")));
}

TEST(IncludeRules, WantPathsFromTheTop) {
    EXPECT_THAT(complaints("csg/torus.cpp", "#include \"torus.hpp\""), ElementsAre(HasSubstr("may not")));
    EXPECT_THAT(complaints("csg/torus.cpp", "  # include \"../csg/torus.hpp\""), ElementsAre(HasSubstr("goes up")));
    EXPECT_THAT(complaints("csg/torus.cpp", "#include \"csg/../cli/run.hpp\""), ElementsAre(HasSubstr("goes up")));
    EXPECT_THAT(complaints("csg/torus.cpp", "#include <cli/run.hpp>"), ElementsAre(HasSubstr("in quotes")));
    EXPECT_THAT(complaints("tests/csg/leaf_test.cpp", "#include \"models.hpp\""), IsEmpty());
}

TEST(IncludeRules, KeepEachLibraryInItsRoom) {
    EXPECT_THAT(complaints("rt_core/trace/embree.hpp", "#include <embree3/rtcore.h>"), IsEmpty());
    EXPECT_THAT(complaints("rt_core/trace/tracer.cpp", "#include <embree3/rtcore.h>"), ElementsAre(HasSubstr("alone")));
    EXPECT_THAT(complaints("formats/mesh/ply.cpp", "#include <CGAL/Exact_rationals.h>"),
                ElementsAre(HasSubstr("alone")));
    EXPECT_THAT(complaints("formats/mesh/ply.cpp", "#include <vector>"), IsEmpty());
}

}  // namespace
}  // namespace cardioid::test

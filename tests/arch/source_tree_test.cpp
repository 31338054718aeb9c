#include "tests/arch/source_tree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/arch/include_rules.hpp"

namespace cardioid::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(SourceTree, HasOnlyTheFoldersThatAreAgreedUpon) {
    const std::set<std::string> agreed{".ci",    "bench",   "cli",     "cmake",   "csg",     "docs",  "formats",
                                       "photon", "rt_core", "samples", "scripts", "shaders", "share", "tests"};
    for (const std::string& folder : top_folders(CARDIOID_SOURCE_DIR))
        EXPECT_TRUE(agreed.contains(folder)) << folder << "/ needs a reason in docs/decisions/ and its name here";
}

TEST(SourceTree, GuardsEveryHeaderAndKeepsFilesShort) {
    for (const Source& source : read_tree(CARDIOID_SOURCE_DIR)) EXPECT_THAT(file_complaints(source), IsEmpty());
}

TEST(SourceTree, SeesAnUnguardedHeader) {
    EXPECT_THAT(file_complaints(parse_source("csg/a.hpp", "struct A {};\n")), ElementsAre(HasSubstr("#pragma once")));
    EXPECT_THAT(file_complaints(parse_source("csg/a.hpp", "#pragma once\nstruct A {};\n")), IsEmpty());
    EXPECT_THAT(file_complaints(parse_source("csg/a.h", "/* C */\n#ifndef A_H\n#define A_H\n#endif\n")), IsEmpty());
    EXPECT_THAT(file_complaints(parse_source("csg/a.cpp", "struct A {};\n")), IsEmpty());
}

TEST(SourceTree, SeesAFileThatIsTooLong) {
    EXPECT_THAT(file_complaints(parse_source("csg/a.cpp", std::string(400, '\n'))), IsEmpty());
    EXPECT_THAT(file_complaints(parse_source("csg/a.cpp", std::string(401, '\n'))),
                ElementsAre(HasSubstr("400 lines")));
    EXPECT_THAT(file_complaints(parse_source("csg/metal_table.cpp", std::string(401, '\n'))), IsEmpty());
}

TEST(SourceTree, ReadsIncludesAsTheyAreWritten) {
    const Source source = parse_source("a.cpp",
                                       "#include <vector>\n\n"
                                       "  #  include\t\"csg/b.hpp\"  // why\n"
                                       "// #include \"csg/not_this.hpp\"\n"
                                       "#include \"csg/last.hpp\"");
    ASSERT_EQ(source.includes.size(), 3U);
    EXPECT_EQ(source.lines, 5U);
    EXPECT_EQ(source.includes[0].path, "vector");
    EXPECT_FALSE(source.includes[0].quoted);
    EXPECT_EQ(source.includes[1].path, "csg/b.hpp");
    EXPECT_EQ(source.includes[1].line, 3U);
    EXPECT_EQ(source.includes[2].path, "csg/last.hpp");
}

}  // namespace
}  // namespace cardioid::test

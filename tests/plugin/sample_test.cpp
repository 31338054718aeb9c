#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "rt_core/api/plugin.h"
#include "tests/cli/program.hpp"

namespace cardioid::test {
namespace {

/// Against the package of the build folder, as somebody else would.
void build_velvet(const Folder& folder) {
    const std::string configure = std::string(CARDIOID_CMAKE) +
                                  " -S '" CARDIOID_SOURCE_DIR
                                  "/samples/plugins/velvet' -B build -Dcardioid_DIR='" CARDIOID_BINARY_DIR
                                  "' -G '" CARDIOID_GENERATOR "' -DCMAKE_CXX_COMPILER='" CARDIOID_COMPILER "'";
    const Outcome configured = folder.shell(configure);
    ASSERT_EQ(configured.status, 0) << configured.out << configured.err;
    const Outcome built = folder.shell(std::string(CARDIOID_CMAKE) + " --build build");
    ASSERT_EQ(built.status, 0) << built.out << built.err;
    ASSERT_TRUE(folder.has("build/velvet.so"));
}

void expect_renders(const Folder& folder) {
    folder.write("velvet.csg", "");
    std::filesystem::copy_file(CARDIOID_SOURCE_DIR "/samples/plugins/velvet/velvet.csg", folder.path("velvet.csg"),
                               std::filesystem::copy_options::overwrite_existing);
    const std::vector<std::string> words{"velvet.csg", "-s", "40x30", "--spp", "4", "-q"};
    const Outcome without = folder.cardioid(words);
    EXPECT_EQ(without.status, 3);
    EXPECT_NE(without.err.find("velvet"), std::string::npos) << without.err;

    std::vector<std::string> with = words;
    with.insert(with.end(), {"--plugin", "build/velvet.so"});
    const Outcome run = folder.cardioid(with);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(folder.has("velvet.png"));
    const std::string path = "CARDIOID_PLUGIN_PATH=" + folder.path("build").string();
    EXPECT_EQ(folder.cardioid(words, {.environment = {path}}).status, 0);
}

TEST(SamplePlugin, IsBuiltOutOfTheTreeListedAndRendered) {
    const Folder folder;
    build_velvet(folder);
    if (HasFatalFailure()) return;
    const Outcome list = folder.cardioid({"list", "shaders", "--plugin", "./build/velvet.so"});
    EXPECT_EQ(list.status, 0) << list.err;
    EXPECT_NE(list.out.find("velvet: cloth with a bright rim"), std::string::npos) << list.out;
    EXPECT_NE(list.out.find("sharpness"), std::string::npos);
    expect_renders(folder);

    const Outcome twice =
        folder.cardioid({"list", "shaders", "--plugin", "build/velvet.so", "--plugin", "build/velvet.so"});
    EXPECT_EQ(twice.status, 2);
    EXPECT_NE(twice.err.find("there is already a shader named \"velvet\""), std::string::npos) << twice.err;
    folder.write("bad.csg", "define_material(\"m\", kind = \"velvet\", sheen = 7);\nmaterial(\"m\") cube(1);");
    const Outcome bad = folder.cardioid({"bad.csg", "--plugin", "build/velvet.so"});
    EXPECT_EQ(bad.status, 3);
    EXPECT_NE(bad.err.find("bad.csg:1:"), std::string::npos) << bad.err;
}

TEST(SamplePlugin, OfAnotherAbiIsRefusedByTheProgramWithBothNumbers) {
    const Outcome run = Folder().cardioid({"list", "shaders", "--plugin", CARDIOID_PLUGIN_DIR "plugin_of_next_abi.so"});
    EXPECT_EQ(run.status, 2);
    const std::string numbers =
        fmt::format("was built for plug-in ABI {}.{}, this program has {}.{}", CARDIOID_ABI_MAJOR + 1,
                    CARDIOID_ABI_MINOR, CARDIOID_ABI_MAJOR, CARDIOID_ABI_MINOR);
    EXPECT_NE(run.err.find(numbers), std::string::npos) << run.err;
}

}  // namespace
}  // namespace cardioid::test

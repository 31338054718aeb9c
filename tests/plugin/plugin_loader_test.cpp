#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

#include "rt_core/api/plugin.h"
#include "rt_core/plugin/registry.hpp"

namespace cardioid::test {
namespace {

namespace fs = std::filesystem;

std::string built(const std::string& name) { return CARDIOID_PLUGIN_DIR + name + ".so"; }

/// That `load` throws an Error of this code whose text has every part.
template <class Load>
void expect_refused(Load&& load, ErrorCode code, const std::vector<std::string>& parts) {
    try {
        load();
        FAIL() << "not refused";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
        for (const std::string& part : parts)
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

void expect_file_refused(const std::string& path, ErrorCode code, const std::vector<std::string>& parts) {
    const auto registry = make_registry();
    expect_refused([&] { load_plugin(path, *registry); }, code, parts);
    EXPECT_TRUE(registry->shaders().empty());
}

TEST(PluginLoader, RefusesAnotherAbiWithBothNumbersAndCallsNothing) {
    const std::string ours = fmt::format("this program has {}.{}", CARDIOID_ABI_MAJOR, CARDIOID_ABI_MINOR);
    const auto theirs = [](int major, int minor) { return fmt::format("plug-in ABI {}.{},", major, minor); };
    expect_file_refused(built("plugin_of_next_abi"), ErrorCode::usage,
                        {ours, theirs(CARDIOID_ABI_MAJOR + 1, CARDIOID_ABI_MINOR)});
    expect_file_refused(built("plugin_of_last_abi"), ErrorCode::usage,
                        {ours, theirs(CARDIOID_ABI_MAJOR - 1, CARDIOID_ABI_MINOR)});
    expect_file_refused(built("plugin_of_later_minor"), ErrorCode::usage,
                        {ours, theirs(CARDIOID_ABI_MAJOR, CARDIOID_ABI_MINOR + 1)});
}

TEST(PluginLoader, RefusesWhatIsNoPlugin) {
    expect_file_refused(built("plugin_without_query"), ErrorCode::usage, {"does not export cardioid_plugin_query"});
    expect_file_refused(built("plugin_of_nothing"), ErrorCode::usage, {"returned nothing"});
    expect_file_refused(built("plugin_without_attach"), ErrorCode::usage, {"has no attach function"});
    expect_file_refused(built("plugin_too_short"), ErrorCode::usage, {"in 8 bytes, wanted at least"});
    expect_file_refused(CARDIOID_SOURCE_DIR "/tests/plugin/faulty.c", ErrorCode::io, {"faulty.c: cannot be loaded"});
    expect_file_refused(CARDIOID_SOURCE_DIR, ErrorCode::io, {"is a folder"});
    expect_file_refused("./no/such.so", ErrorCode::io, {"./no/such.so: no such plug-in file"});
}

TEST(PluginLoader, TellsWhyAPluginDidNotAttach) {
    expect_file_refused(built("plugin_that_refuses"), ErrorCode::usage,
                        {"plug-in \"faulty\" 0.1 did not attach: the moon is not full"});
}

TEST(PluginLoader, NeverSearchesForABareName) {
    const fs::path here = fs::current_path();
    fs::current_path(CARDIOID_PLUGIN_DIR);
    ASSERT_TRUE(fs::exists("plugin_velvet.so"));
    expect_file_refused("plugin_velvet.so", ErrorCode::usage, {"write ./plugin_velvet.so"});
    const auto registry = make_registry();
    load_plugin("./plugin_velvet.so", *registry);
    EXPECT_EQ(registry->shaders().size(), 1U);
    fs::current_path(here);
}

TEST(PluginLoader, RefusesANameThatIsTakenAndKeepsWhatThereWas) {
    const auto registry = make_registry();
    load_plugin(built("plugin_velvet"), *registry);
    expect_refused([&] { load_plugin(built("plugin_velvet"), *registry); }, ErrorCode::usage,
                   {"did not attach: there is already a shader named \"velvet\""});
    EXPECT_EQ(registry->shaders().size(), 1U);
}

class PluginPath : public testing::Test {
protected:
    PluginPath() {
        std::string name = (fs::temp_directory_path() / "cardioid-plugins-XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~PluginPath() override {
        unsetenv("CARDIOID_PLUGIN_PATH");
        fs::remove_all(folder);
    }
    static void set(const std::string& value) { setenv("CARDIOID_PLUGIN_PATH", value.c_str(), 1); }
    fs::path folder;
};

TEST_F(PluginPath, LoadsEverySharedObjectOfItsFolders) {
    fs::copy_file(built("plugin_velvet"), folder / "velvet.so");
    std::ofstream(folder / "readme.txt") << "no plug-in";
    set(fmt::format(":{}:", folder.string()));
    const auto registry = make_registry();
    load_plugin_path(*registry);
    EXPECT_EQ(registry->shaders().size(), 1U);
}

TEST_F(PluginPath, RefusesFoldersThatAreNotAbsoluteOrNotThere) {
    const auto registry = make_registry();
    set("plugins");
    expect_refused([&] { load_plugin_path(*registry); }, ErrorCode::usage, {"\"plugins\" is not an absolute folder"});
    set((folder / "none").string());
    expect_refused([&] { load_plugin_path(*registry); }, ErrorCode::io, {"CARDIOID_PLUGIN_PATH: ", "none"});
    unsetenv("CARDIOID_PLUGIN_PATH");
    EXPECT_NO_THROW(load_plugin_path(*registry));
}

}  // namespace
}  // namespace cardioid::test

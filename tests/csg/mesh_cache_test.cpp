#include "csg/exact/mesh_cache.hpp"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "csg/shapes/facets.hpp"

namespace cardioid::csg {
namespace {

namespace fs = std::filesystem;

/// A cache folder of its own, gone with the test.
class MeshCache : public testing::Test {
protected:
    MeshCache() {
        setenv("XDG_CACHE_HOME", home_.c_str(), 1);
        unsetenv("CARDIOID_CACHE");
    }
    ~MeshCache() override {
        std::error_code ignored;
        fs::remove_all(home_, ignored);
        setenv("CARDIOID_CACHE", "0", 1);
    }

    /// Whether the mesh had to be made; however quickly, it is kept.
    bool makes(std::uint64_t key) {
        ContentHash hash;
        hash.add(key);
        bool made = false;
        const auto make = [&] {
            made = true;
            return std::vector{ball_, TriangleMesh{}};
        };
        const std::vector<TriangleMesh> got = cached(hash, make, 0);
        EXPECT_EQ(got.size(), 2U);
        EXPECT_EQ(got[0].vertices, ball_.vertices);
        EXPECT_EQ(got[0].triangles, ball_.triangles);
        EXPECT_EQ(got[0].closed, ball_.closed);
        return made;
    }
    [[nodiscard]] std::vector<fs::path> files() const {
        std::vector<fs::path> out;
        for (const auto& entry : fs::directory_iterator(folder_)) out.push_back(entry.path());
        return out;
    }

    fs::path home_ = fs::temp_directory_path() / ("cardioid-cache-" + std::to_string(getpid()));
    fs::path folder_ = home_ / "cardioid";
    TriangleMesh ball_ = faceted_sphere(2, 12);
};

TEST_F(MeshCache, KeepsWhatTookLongAndNothingElse) {
    ContentHash quick;
    quick.add(std::uint64_t{7});
    cached(quick, [&] { return std::vector{ball_}; });
    EXPECT_TRUE(files().empty());
    EXPECT_TRUE(makes(1));
    EXPECT_FALSE(makes(1));
    EXPECT_EQ(files().size(), 1U);
}

TEST_F(MeshCache, MakesAgainWhatIsDamaged) {
    ASSERT_TRUE(makes(1));
    const fs::path file = files().at(0);
    std::string bytes(fs::file_size(file), '\0');
    std::ifstream(file, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const auto write = [&](const std::string& text) { std::ofstream(file, std::ios::binary) << text; };
    std::string flipped = bytes;
    flipped[bytes.size() / 2] = static_cast<char>(flipped[bytes.size() / 2] ^ 1);
    write(flipped);
    EXPECT_TRUE(makes(1));
    write(bytes.substr(0, bytes.size() - 5));
    EXPECT_TRUE(makes(1));
    write("");
    EXPECT_TRUE(makes(1));
    EXPECT_FALSE(makes(1));  // and what was made again is kept
}

TEST_F(MeshCache, IsBoundedAndTheLongestUnusedGoesFirst) {
    ASSERT_TRUE(makes(1));
    const fs::path small = files().at(0), old = folder_ / "old", older = folder_ / "older";
    const auto now = fs::file_time_type::clock::now();
    for (const fs::path& file : {old, older}) {  // sparse: no disk is filled
        std::ofstream(file) << "x";
        fs::resize_file(file, std::uintmax_t{200} << 20);
    }
    fs::last_write_time(old, now - std::chrono::hours(1));
    fs::last_write_time(older, now - std::chrono::hours(2));
    EXPECT_TRUE(makes(2));
    EXPECT_FALSE(fs::exists(older));
    EXPECT_TRUE(fs::exists(old));
    EXPECT_TRUE(fs::exists(small));
}

TEST_F(MeshCache, MayBeSharedByProcesses) {
    constexpr int processes = 4;
    for (int i = 0; i < processes; ++i)
        if (fork() == 0) {
            for (std::uint64_t key = 0; key < 3; ++key) makes(key);
            _exit(HasFailure() ? 1 : 0);
        }
    for (int i = 0; i < processes; ++i) {
        int status = 0;
        wait(&status);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }
    EXPECT_EQ(files().size(), 3U);  // no file of a process is left behind
    for (std::uint64_t key = 0; key < 3; ++key) EXPECT_FALSE(makes(key));
}

TEST_F(MeshCache, MakesEverythingWhereItsFolderCannotBe) {
    fs::create_directories(home_);
    std::ofstream(folder_) << "a file where the folder should be";
    EXPECT_TRUE(makes(1));
    EXPECT_TRUE(makes(1));
}

TEST_F(MeshCache, KeepsNothingWhereItIsSwitchedOff) {
    setenv("CARDIOID_CACHE", "0", 1);
    EXPECT_TRUE(makes(1));
    EXPECT_FALSE(fs::exists(folder_));
}

}  // namespace
}  // namespace cardioid::csg

#include <gtest/gtest.h>

#include "tests/photon_module/lit_scenes.hpp"

namespace cardioid::test {
namespace {

struct Files {
    std::string map, picture, points;
    bool operator==(const Files&) const = default;
};

/// Bytes of what the program writes with so many threads: the map, the picture, and a picture of the cache points.
Files files_of(const Folder& folder, const std::string& threads, const std::vector<std::string>& more) {
    std::vector<std::string> words = more;
    words.insert(words.end(), {"-q", "-j", threads, "-o"});
    const auto run = [&](const std::vector<std::string>& last) {
        std::vector<std::string> all = words;
        all.insert(all.end(), last.begin(), last.end());
        const Outcome outcome = folder.cardioid(photon_words("room.csg", all));
        EXPECT_EQ(outcome.status, 0) << outcome.err;
    };
    run({"a.exr", "--save-map", "a.map"});
    run({"b.exr", "--view", "cache"});
    return {folder.read("a.map"), folder.read("a.exr"), folder.read("b.exr")};
}

void expect_same_files(const std::vector<std::string>& more) {
    const Folder folder;
    folder.write("room.csg", lit_room);
    const Files one = files_of(folder, "1", more);
    EXPECT_GT(one.map.size(), 10'000U);
    for (const char* const threads : {"2", "7"}) {
        const Files other = files_of(folder, threads, more);
        EXPECT_TRUE(one.map == other.map) << threads << " threads";
        EXPECT_TRUE(one.picture == other.picture) << threads << " threads";
        EXPECT_TRUE(one.points == other.points) << threads << " threads";
    }
    std::vector<std::string> seeded = more;
    seeded.insert(seeded.end(), {"--seed", "5"});
    const Files seven = files_of(folder, "2", seeded);
    EXPECT_FALSE(one.map == seven.map || one.picture == seven.picture || one.points == seven.points);
}

// Whole files: what any digest of them says follows.
TEST(PhotonModule, WritesTheSameMapCacheAndPictureForOneTwoAndSevenThreads) { expect_same_files({}); }

TEST(PhotonModule, OfTheReportWritesTheSameMapCacheAndPictureForOneTwoAndSevenThreads) {
    expect_same_files({"--set", "photon.mode=report", "--set", "photon.keep_map=true"});
}

}  // namespace
}  // namespace cardioid::test

#include <chrono>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <signal.h>
#include <thread>

#include "tests/photon_module/lit_scenes.hpp"

namespace cardioid::test {
namespace {

/// A folder with the room and its saved map.
class SavedMap : public testing::Test {
protected:
    SavedMap() {
        folder.write("room.csg", lit_room);
        const Outcome run = folder.call(photon_words("room.csg", {"-q", "-o", "a.exr", "--save-map", "a.map"}));
        EXPECT_EQ(run.status, 0) << run.err;
    }
    [[nodiscard]] Outcome load(const std::string& map, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"-q", "-o", "b.exr", "--load-map", map};
        words.insert(words.end(), more.begin(), more.end());
        return folder.call(photon_words("room.csg", words));
    }
    void expect_refused(const Outcome& run, int status, const std::string& part) const {
        EXPECT_EQ(run.status, status) << run.err;
        EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
        EXPECT_FALSE(folder.has("b.exr"));
    }
    Folder folder;
};

TEST_F(SavedMap, GivesTheSamePicture) {
    EXPECT_EQ(load("a.map").status, 0);
    const Outcome compared = folder.call({"compare", "a.exr", "b.exr"});
    EXPECT_NE(compared.out.find("the same to the last bit"), std::string::npos) << compared.out;
}

TEST_F(SavedMap, OfTheReportsCacheGivesTheSamePicture) {
    const std::vector<std::string> report{"--set", "photon.mode=report", "-q", "-o"};
    for (const std::vector<std::string>& last :
         {std::vector<std::string>{"c.exr", "--save-map", "c.map"}, {"d.exr", "--load-map", "c.map"}}) {
        std::vector<std::string> words = report;
        words.insert(words.end(), last.begin(), last.end());
        const Outcome run = folder.call(photon_words("room.csg", words));
        EXPECT_EQ(run.status, 0) << run.err;
    }
    const Outcome compared = folder.call({"compare", "c.exr", "d.exr"});
    EXPECT_NE(compared.out.find("the same to the last bit"), std::string::npos) << compared.out;
}

TEST_F(SavedMap, ThatDoesNotBelongIsRefusedWithTheReason) {
    const std::string map = folder.read("a.map");
    folder.write("cut.map", map.substr(0, map.size() / 2));
    folder.write("empty.map", "");
    std::string changed = map;
    changed[map.size() / 2] ^= 1;
    folder.write("changed.map", changed);
    expect_refused(load("cut.map"), 3, "cut.map: this map is refused: it is truncated");
    expect_refused(load("empty.map"), 3, "it is no map file of Cardioid");
    expect_refused(load("room.csg"), 3, "it is no map file of Cardioid");
    expect_refused(load("changed.map"), 3, "is damaged");
    expect_refused(load("a.map", {"--set", "photon.k=70"}), 3, "it was made with k = automatic, this is k = 70");
    expect_refused(load("a.map", {"--set", "photon.mode=report"}), 3, "it was made with count_by_faces = false");
    expect_refused(load("a.map", {"--seed", "3"}), 3, "it was made with seed = 0, this is seed = 3");
    expect_refused(load("none.map"), 4, "none.map: cannot read the map: No such file");
    expect_refused(load("/"), 4, "/: cannot read the map: Is a directory");
    expect_refused(load("a.map", {"--lighting", "photon", "--ground"}), 3, "it was made for another scene");
    folder.write("room.csg", lit_room + "cube(3);");
    expect_refused(load("a.map"), 3, "it was made for another scene, or this one has changed since");
    folder.write("room.csg", lit_room);
    expect_refused(folder.call({"room.csg", "-o", "b.exr", "--load-map", "a.map"}), 2, "no map to load");
}

TEST_F(SavedMap, TellsWhatIsInIt) {
    const Outcome text = folder.call({"info", "a.map"});
    EXPECT_EQ(text.status, 0) << text.err;
    for (const char* const part :
         {"photon map of scene ", "section radiance: ", "section caustics: ", "edge = ", "seed = 0"})
        EXPECT_NE(text.out.find(part), std::string::npos) << part << " in " << text.out;
    const auto json = nlohmann::json::parse(folder.call({"info", "a.map", "--json", "-"}).out);
    EXPECT_EQ(json["options"]["count"], "3000");
    EXPECT_EQ(json["sections"][0]["name"], "options");
    folder.write("cut.map", folder.read("a.map").substr(0, 1000));
    EXPECT_EQ(folder.call({"info", "cut.map"}).status, 3);
}

// Neither the scene nor what is written otherwise is lost to a map.
TEST_F(SavedMap, OverwritesNeitherTheSceneNorAnotherResult) {
    const auto refused = [&](const std::vector<std::string>& words, const std::string& part) {
        const Outcome run = folder.call(photon_words("room.csg", words));
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
        EXPECT_EQ(folder.read("room.csg"), lit_room);
    };
    refused({"--save-map", "room.csg"}, "--save-map: room.csg is the scene itself");
    refused({"--save-map", "./room.csg"}, "is the scene itself");
    refused({"--stats", "room.csg"}, "--stats: room.csg is the scene itself");
    refused({"--save-map", "x.exr", "-o", "x.exr"}, "name the same file");
    refused({"--save-map", "x.json", "--stats", "x.json"}, "name the same file");
}

// Of a map that nobody waits for to be whole nothing is left, nor of the picture.
TEST_F(SavedMap, IsNotWrittenWhereItsMakingIsInterrupted) {
    for (const char* const phase : {"photons\n", "cache\n"}) {
        const Folder other;
        other.write("room.csg", lit_room);
        const bool late = phase[0] == 'c' && phase[1] == 'a' && phase[2] == 'c';
        const pid_t process =
            other.begin({"room.csg", late ? "--photons=3000" : "--photons=40000000", "--set", "photon.memory=1e6",
                         "--set", late ? "photon.hemisphere=300,900" : "photon.k=50", "-s", "400", "-v", "-o", "a.exr",
                         "--save-map", "a.map"});
        for (int i = 0; i < 600 && other.messages().find(phase) == std::string::npos; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        kill(process, SIGINT);
        const Outcome run = other.finish(process);
        EXPECT_EQ(run.status, 130) << run.err;
        EXPECT_NE(run.err.find("interrupted before the first pixel; nothing is saved"), std::string::npos) << run.err;
        EXPECT_EQ(other.names(), (std::vector<std::string>{"room.csg"})) << phase;
    }
}

}  // namespace
}  // namespace cardioid::test

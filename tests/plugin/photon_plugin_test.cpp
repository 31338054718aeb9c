#include <cstring>
#include <gtest/gtest.h>

#include "rt_core/image/image_file.hpp"
#include "tests/photon_module/lit_scenes.hpp"

namespace cardioid::test {
namespace {

/// All layers of the room's picture by this lighting, as they are in memory.
std::vector<float> pixels_by(const std::string& lighting, const std::string& scene, std::vector<std::string> words) {
    const Folder folder;
    folder.write("room.csg", scene);
    words.insert(words.begin(),
                 {"room.csg", "--plugin", CARDIOID_BINARY_DIR "/photon/photon_plugin.so", "--lighting", lighting, "-s",
                  "40x32", "--spp", "2", "-q", "-o", "a.exr", "--aov", "direct,indirect,caustic,specular"});
    const auto set = [&](const std::string& value) { words.insert(words.end(), {"--set", lighting + "." + value}); };
    set("count=3000");
    set("caustic_count=3000");
    set("hemisphere=6,18");
    const Outcome run = folder.cardioid(words);
    EXPECT_EQ(run.status, 0) << run.err;
    std::vector<float> all;
    for (const Layer& layer : read_image(folder.path("a.exr").string()).layers)
        all.insert(all.end(), layer.pixels.begin(), layer.pixels.end());
    return all;
}

// The hooks are enough for photon mapping: the same objects, loaded, draw the same picture.
TEST(PhotonPlugin, DrawsByteForByteThePictureOfTheModuleThatIsLinkedIn) {
    const std::vector<float> linked = pixels_by("photon", lit_room, {}),
                             loaded = pixels_by("photon_plugin", lit_room, {});
    ASSERT_EQ(linked.size(), loaded.size());
    EXPECT_GE(linked.size(), 40U * 32 * 3 * 5);
    EXPECT_EQ(std::memcmp(linked.data(), loaded.data(), linked.size() * sizeof(float)), 0);
    const std::vector<float> other = pixels_by("photon_plugin", lit_room, {"--seed", "3"});
    EXPECT_NE(std::memcmp(linked.data(), other.data(), linked.size() * sizeof(float)), 0);
}

TEST(PhotonPlugin, ListsItsOptionsAndTakesMaps) {
    const Folder folder;
    folder.write("room.csg", lit_room);
    const std::string plugin = CARDIOID_BINARY_DIR "/photon/photon_plugin.so";
    const Outcome list = folder.cardioid({"list", "lighting", "--plugin", plugin});
    EXPECT_NE(list.out.find("photon_plugin: photon mapping"), std::string::npos) << list.out;
    const auto draw = [&](const std::vector<std::string>& map) {
        std::vector<std::string> words{"room.csg",      "--plugin", plugin,  "--lighting",
                                       "photon_plugin", "-s",       "16",    "-q",
                                       "--spp",         "1",        "--set", "photon_plugin.count=500"};
        words.insert(words.end(), map.begin(), map.end());
        return folder.cardioid(words);
    };
    EXPECT_EQ(draw({"--save-map", "a.map"}).status, 0);
    EXPECT_EQ(draw({"--load-map", "a.map"}).status, 0);
    const Outcome refused = draw({"--load-map", "room.csg"});
    EXPECT_EQ(refused.status, 3);
    EXPECT_NE(refused.err.find("no map file of Cardioid"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace cardioid::test

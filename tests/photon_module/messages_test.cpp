#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

#include "photon/options/photon_options.hpp"
#include "rt_core/image/image_file.hpp"
#include "tests/photon_module/lit_scenes.hpp"

namespace cardioid::test {
namespace {

using nlohmann::json;

/// The room's picture with words besides.
Outcome drawn(const Folder& folder, const std::vector<std::string>& more) {
    folder.write("room.csg", lit_room);
    std::vector<std::string> words{"room.csg", "-s", "24", "--spp", "1", "--set", "photon.error=0.3"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = folder.call(words);
    EXPECT_EQ(run.status, 0) << run.err;
    return run;
}

// Note [1] of the report: all parameters are found automatically; here they are told, too.
TEST(PhotonMessages, HaveEveryAutomaticParameterWithItsReason) {
    const Folder folder;
    const std::string told = drawn(folder, {"--photons", "-v"}).err;
    int automatic = 0;
    for (const ParamSpec& param : photon::photon_params()) {
        if (std::string(param.fallback) != "automatic" && std::string(param.fallback) != "half of RAM") continue;
        ++automatic;
        EXPECT_NE(told.find("\nphoton." + std::string(param.name) + " = "), std::string::npos) << param.name << told;
    }
    EXPECT_EQ(automatic, 9);
    const std::string quiet = drawn(folder, {"--photons"}).err;
    EXPECT_EQ(quiet.find("photon."), std::string::npos) << quiet;
}

TEST(PhotonMessages, NameEveryPhaseAndItsSeconds) {
    const Folder folder;
    const Outcome run = drawn(folder, {"--photons", "-v", "--stats", "a.json", "--save-map", "a.map"});
    const json lighting = json::parse(folder.read("a.json"))["lighting"];
    for (const std::string phase : {"plan", "caustics", "photons", "radiance photons", "cache"}) {
        EXPECT_NE(run.err.find("\n" + phase + "\n"), std::string::npos) << phase << run.err;
        EXPECT_GE(lighting["seconds " + phase], 0.0) << phase;
    }
    const Outcome loaded = drawn(folder, {"--photons", "-v", "--stats", "b.json", "--load-map", "a.map"});
    EXPECT_NE(loaded.err.find("\nload\n"), std::string::npos) << loaded.err;
    EXPECT_GT(json::parse(folder.read("b.json"))["lighting"]["seconds cache"], 0.0);
}

TEST(PhotonMessages, AccountForCountsBytesAndFlux) {
    const Folder folder;
    static_cast<void>(drawn(folder, {"--photons=20k", "--stats", "a.json"}));
    const json lighting = json::parse(folder.read("a.json"))["lighting"];
    EXPECT_EQ(lighting["photons emitted"], 20'000);
    for (const char* const name : {"photons stored", "caustic photons stored", "radiance photons", "cache points",
                                   "caustic cache points", "photon bytes", "cache bytes", "caustic cache bytes"})
        EXPECT_GT(lighting[name], 0) << name;
    const double emitted = lighting["photons W emitted"], absorbed = lighting["photons W absorbed"],
                 escaped = lighting["photons W escaped"], cut = lighting["photons W cut off"];
    EXPECT_NEAR((absorbed + escaped + cut) / emitted, 1, 1e-5);
    EXPECT_NEAR(emitted / (3.14159265 * 144 * (40 + 38 + 30)), 1, 1e-5);
}

// Debug pictures: every view of the module is drawn and is neither even nor black.
TEST(PhotonViews, AreAllDrawnAndShowSomething) {
    const Folder folder;
    for (const char* const view : {"photons", "map", "lookup", "gather", "cache", "irradiance", "radius"})
        for (const char* const mode : {"physical", "report"}) {
            static_cast<void>(
                drawn(folder, {"--photons=2000", "--view", view, "--set", std::string("photon.mode=") + mode, "-o",
                               "v.exr", "-s", "48", "--set", "photon.view_pixel=20,40", "--set",
                               "photon.caustic_count=0", "--set", "photon.hemisphere=6,18"}));
            const std::vector<float> pixels = read_image(folder.path("v.exr").string()).layers.at(0).pixels;
            const std::set<float> values(pixels.begin(), pixels.end());
            EXPECT_GE(values.size(), 3U) << view << " of mode " << mode;
            EXPECT_GT(*values.rbegin(), 0.0F) << view;
        }
}

TEST(PhotonViews, OfNoSuchNameAreRefusedWithTheNamesThereAre) {
    const Folder folder;
    folder.write("room.csg", lit_room);
    const Outcome run = folder.call({"room.csg", "--photons", "--view", "lokup"});
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("did you mean \"lookup\""), std::string::npos) << run.err;
}

}  // namespace
}  // namespace cardioid::test

#include <gtest/gtest.h>

#include "tests/photon_module/lit_scenes.hpp"

namespace cardioid::test {
namespace {

const std::string eye = "camera([0, -50, 10], look_at = [0, 0, 0]);\n";
const std::string lamp = "translate([0, 0, 40]) point_light(intensity = 1000);\n";

/// What the program says of a scene with --photons and these words besides; it must end with `status`.
std::string said(const std::string& scene, int status, const std::vector<std::string>& more = {}) {
    const Folder folder;
    folder.write("a.csg", scene);
    std::vector<std::string> words{"a.csg", "-s", "16", "--spp", "1", "--photons"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = folder.call(words);
    EXPECT_EQ(run.status, status) << run.err;
    EXPECT_EQ(folder.has("a.png"), status == 0);
    return run.err;
}

void expect_said(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(PhotonFaults, WithoutLightAreToldWithWhatToDo) {
    expect_said(said(eye + "cube(10, center = true); sky(radiance = 0);", 0),
                "warning: no light sends photons: indirect light is black; add a light, or leave out --photons");
}

TEST(PhotonFaults, OfLightThatMissesTheModelAreToldWithWhatToDo) {
    expect_said(said(eye + "cube(10, center = true); translate([0, 0, 400]) rotate([180, 0, 0]) "
                           "area_light([1, 1], radiance = 1000);",
                     0),
                "was kept: the lights do not shine on the model");
}

TEST(PhotonFaults, OfAnAllBlackSceneAreToldWithWhatToDo) {
    expect_said(
        said(eye + lamp + "define_material(\"b\", kind = \"diffuse\", reflectance = 0); material(\"b\") cube(9);", 0),
        "all that the lights shine on is black, so there is no indirect light; give materials a reflectance");
}

TEST(PhotonFaults, OfAnAllMirrorSceneAreToldWithWhatToDo) {
    expect_said(
        said(eye + lamp + "define_material(\"m\", kind = \"mirror\"); material(\"m\") cube(9);", 0),
        "only mirrors and glass: --photons adds nothing here; give something a material that is not all mirror");
}

TEST(PhotonFaults, OfAnOrdinarySceneAreNone) {
    EXPECT_EQ(
        said("camera([0, -50, 40], look_at = [0, 0, 0]);\n" + lamp + "cube(10, center = true);", 0).find("warning"),
        std::string::npos);
    EXPECT_EQ(said(lit_room, 0, {"--photons=3000"}).find("warning"), std::string::npos);
}

TEST(PhotonFaults, OfOnePhotonAreNone) {
    EXPECT_EQ(said(lit_room, 0, {"--photons=1", "--set", "photon.caustic_count=1"}).find("warning"), std::string::npos);
    static_cast<void>(
        said(lit_room, 0, {"--photons=1", "--set", "photon.caustic_count=0", "--set", "photon.mode=report"}));
    static_cast<void>(
        said(lit_room, 0, {"--photons=1", "--set", "photon.caustic_count=0", "--set", "photon.indirect=map"}));
    static_cast<void>(
        said(lit_room, 0, {"--photons=1", "--set", "photon.caustic_count=0", "--set", "photon.indirect=gather"}));
}

TEST(PhotonFaults, OfOnePhotonThatMissesAreToldAsTooFew) {
    expect_said(said(eye + "translate([0, 0, 40]) point_light(intensity = 1000); sphere(1);", 0, {"--photons=1"}),
                "none of 1 photon was kept: so few may miss everything; ask for more");
}

TEST(PhotonFaults, OfMorePhotonsThanMemoryHoldsAreToldWithTheEstimate) {
    const std::string text = said(lit_room, 5, {"--photons=100000000", "--set", "photon.memory=500"});
    expect_said(text, "photon.count: 100000000 photons store about ");
    expect_said(text, "MB, photon.memory is 500 MB: ask for at most ");
    // What the program chooses itself it bounds.
    expect_said(said(lit_room, 0, {"--set", "photon.memory=1", "-v"}), "photon.memory is 1 MB");
}

TEST(PhotonFaults, OfMaterialsThatAreNoNumbersAreRefusedWithThePlace) {
    for (const char* const value : {"1e999", "[0.5, 1e999, 0.5]", "2", "-0.1"}) {
        const std::string text = said(eye + lamp + "define_material(\"n\", kind = \"diffuse\", reflectance = " + value +
                                          "); material(\"n\") cube(9);",
                                      3);
        expect_said(text, "a.csg:");
    }
}

}  // namespace
}  // namespace cardioid::test

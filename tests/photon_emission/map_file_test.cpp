#include <cstring>
#include <filesystem>
#include <gtest/gtest.h>
#include <iterator>

#include "emission_kit.hpp"

#include "photon/file/map_reader.hpp"
#include "photon/file/shape_text.hpp"

namespace cardioid {
namespace {

namespace fs = std::filesystem;
using photon::MapReader;
using photon::MapWriter;

/// A folder of this test's own, gone with it.
class MapFile : public ::testing::Test {
protected:
    MapFile() {
        folder_ = fs::temp_directory_path() /
                  (std::string("cardioid-map-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        path = (folder_ / "room.map").string();
    }
    ~MapFile() override { fs::remove_all(folder_); }

    void write() const {
        MapWriter writer(path, 77);
        writer.add_text("options", photon::shape_text({}, 5));
        writer.add_photons("global", shot.photons, shot.origin, shot.flux_scale);
        const double numbers[] = {1, 2, 3};
        writer.add("numbers", std::span<const double>(numbers));
        writer.finish();
    }
    [[nodiscard]] std::string bytes() const {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    void put(const std::string& content) const { std::ofstream(path, std::ios::binary) << content; }
    /// What opening the file is refused with.
    [[nodiscard]] std::string refusal(ErrorCode code = ErrorCode::bad_input) const {
        try {
            const MapReader reader(path);
            return {};
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), code);
            return error.what();
        }
    }
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
    }

    fs::path folder_;
    std::string path;
    photon::Shot shot = test::shoot(test::lit_room("diffuse", {{"reflectance", {0.5, 0.5, 0.5}}}).commit(), 40);
};

TEST_F(MapFile, BringsBackWhatWasWritten) {
    write();
    const MapReader reader(path);
    EXPECT_EQ(reader.scene(), 77U);
    const photon::PhotonSet set = reader.photons("global");
    ASSERT_EQ(set.photons.size(), shot.photons.size());
    EXPECT_EQ(std::memcmp(set.photons.data(), shot.photons.data(), shot.photons.size() * 32), 0);
    EXPECT_EQ(set.origin, shot.origin);
    EXPECT_EQ(set.flux_scale, shot.flux_scale);
    EXPECT_EQ(reader.items<double>("numbers"), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(reader.entries().size(), 4U);
    EXPECT_TRUE(photon::is_map_file(path));
    EXPECT_EQ(files(), 1U);
}

TEST_F(MapFile, OfAnotherSceneIsRefused) {
    write();
    const MapReader reader(path);
    reader.require_scene(77);
    EXPECT_THROW(reader.require_scene(78), Error);
}

TEST_F(MapFile, OfOtherOptionsIsRefusedWithTheOneThatDiffers) {
    write();
    const MapReader reader(path);
    reader.require_text("options", photon::shape_text({}, 5));
    photon::PhotonOptions other;
    other.edge = photon::EdgeRule::none;
    try {
        reader.require_text("options", photon::shape_text(other, 5));
        FAIL() << "other options were taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_input);
        EXPECT_NE(std::string(error.what()).find("made with edge = probe, this is edge = none"), std::string::npos);
    }
    // What only rendering reads may change.
    photon::PhotonOptions later;
    later.caustic_k = 20;
    reader.require_text("options", photon::shape_text(later, 5));
}

TEST_F(MapFile, CutAnywhereIsTruncated) {
    write();
    const std::string whole = bytes();
    for (std::size_t n = 8; n < whole.size(); n += 131) {
        put(whole.substr(0, n));
        ASSERT_NE(refusal().find("truncated"), std::string::npos) << n;
    }
}

TEST_F(MapFile, WithAnyByteChangedIsRefused) {
    write();
    const std::string whole = bytes();
    for (std::size_t n = 0; n < whole.size(); n += 83) {
        std::string changed = whole;
        changed[n] = static_cast<char>(changed[n] ^ 0x10);
        put(changed);
        ASSERT_NE(refusal(), "") << n;
    }
}

TEST_F(MapFile, OfAnotherKindOrVersionOrMachineSaysSo) {
    put("solid box\n");
    EXPECT_NE(refusal().find("no map file"), std::string::npos);
    EXPECT_FALSE(photon::is_map_file(path));
    write();
    std::string changed = bytes();
    changed[8] = 9;
    put(changed);
    EXPECT_NE(refusal().find("version 9, wanted 4"), std::string::npos);
    changed[8] = 1;  // its caustic radius meant something else
    put(changed);
    EXPECT_NE(refusal().find("version 1, wanted 4"), std::string::npos);
    write();
    changed = bytes();
    std::swap(changed[12], changed[15]);
    std::swap(changed[13], changed[14]);
    put(changed);
    EXPECT_NE(refusal().find("byte order"), std::string::npos);
    fs::remove(path);
    EXPECT_NE(refusal(ErrorCode::io).find("cannot read"), std::string::npos);
}

TEST_F(MapFile, IsNotThereUntilItIsFinished) {
    put("what was there before");
    {
        MapWriter writer(path, 1);
        writer.add_text("options", "count = 3\n");
    }
    EXPECT_EQ(bytes(), "what was there before");
    EXPECT_EQ(files(), 1U);
    EXPECT_THROW(MapWriter(folder_.string(), 1), Error);
    EXPECT_THROW(MapWriter((folder_ / "no" / "room.map").string(), 1), Error);
}

TEST_F(MapFile, LacksSectionsWithAReason) {
    write();
    const MapReader reader(path);
    EXPECT_FALSE(reader.has("cache"));
    EXPECT_THROW(static_cast<void>(reader.photons("cache")), Error);
    EXPECT_THROW(static_cast<void>(reader.items<float>("numbers")), Error);
}

}  // namespace
}  // namespace cardioid

#include "rt_core/image/image_file.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <thread>

#include "scratch_folder.hpp"

#include "rt_core/api/error.hpp"
#include "rt_core/image/encode.hpp"

namespace cardioid {
namespace {

using test::ScratchFolder;

/// A picture of 5 x 3 pixels whose values all differ, with a colour layer and a one-channel layer.
Film sample_film() {
    Film film{5, 3, {}};
    for (const auto& [name, channels] : {std::pair{"", 3}, {"direct", 3}, {"normal", 3}, {"depth", 1}, {"region", 1}}) {
        Layer layer{name, channels, {}};
        for (int i = 0; i < 15 * channels; ++i)
            layer.pixels.push_back(static_cast<float>(i) / static_cast<float>(15 * channels));
        film.layers.push_back(layer);
    }
    return film;
}

Film grey_film(std::vector<float> values) {
    Layer layer{"", 3, {}};
    for (const float v : values) layer.pixels.insert(layer.pixels.end(), {v, v, v});
    return {static_cast<int>(values.size()), 1, {layer}};
}

std::string error_of(auto&& call, ErrorCode code) {
    try {
        call();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code);
        return error.what();
    }
    ADD_FAILURE() << "nothing thrown";
    return {};
}

TEST(ImageFile, HoldsEveryLayerOfAnExrAsItIs) {
    const ScratchFolder folder;
    const Film film = sample_film();
    write_image(folder.file("a.exr"), film, {});
    const Film back = read_image(folder.file("a.exr"));
    ASSERT_EQ(back.width, 5);
    ASSERT_EQ(back.height, 3);
    ASSERT_EQ(back.layers.size(), film.layers.size());
    for (const Layer& layer : film.layers) {
        const Layer* found = back.layer(layer.name);
        ASSERT_TRUE(found) << layer.name;
        EXPECT_EQ(found->channels, layer.channels) << layer.name;
        EXPECT_EQ(found->pixels, layer.pixels) << layer.name;
    }
}

/// Noise cannot be made smaller, even light can; 53 lines are blocks of 16 and a rest.
TEST(ImageFile, HoldsEveryBlockOfALargerExr) {
    const ScratchFolder folder;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> u(-1, 1);
    for (const bool noise : {true, false}) {
        Film film{37, 53, {{"", 3, {}}, {"a layer whose name is longer than 31 letters", 3, {}}, {"depth", 1, {}}}};
        for (Layer& layer : film.layers)
            for (int i = 0; i < 37 * 53 * layer.channels; ++i)
                layer.pixels.push_back(noise ? std::exp(20 * u(random)) : 0.25F);
        film.layers[0].pixels[5] = std::numeric_limits<float>::infinity();
        for (const bool half : {false, true}) {
            write_image(folder.file("a.exr"), film, {.half = half, .metadata = {}});
            const Film back = read_image(folder.file("a.exr"));
            ASSERT_EQ(back.layers.size(), 3U);
            for (const Layer& layer : film.layers) {
                const auto& found = back.layer(layer.name)->pixels;
                ASSERT_EQ(found.size(), layer.pixels.size());
                for (std::size_t i = 0; i < found.size(); ++i) {
                    const float x = layer.pixels[i], step = half && layer.channels > 1 ? 0x1p-11F * x + 0x1p-25F : 0;
                    if (step > 0 && x > 65504 && std::isfinite(x))
                        EXPECT_EQ(found[i], 65504);
                    else if (!std::isfinite(x))
                        EXPECT_EQ(found[i], x);
                    else
                        EXPECT_NEAR(found[i], x, step);
                }
            }
        }
    }
}

TEST(ImageFile, KeepsIdsAndDistancesWholeInAHalfExr) {
    const ScratchFolder folder;
    Film film = sample_film();
    film.layers[4].pixels[7] = 123457;
    write_image(folder.file("a.exr"), film, {.half = true});
    const Film back = read_image(folder.file("a.exr"));
    EXPECT_EQ(back.layer("region")->pixels, film.layers[4].pixels);
    EXPECT_EQ(back.layer("depth")->pixels, film.layers[3].pixels);
    const auto& half = back.layer("")->pixels;
    EXPECT_NE(half, film.layers[0].pixels);
    for (std::size_t i = 0; i < half.size(); ++i) EXPECT_NEAR(half[i], film.layers[0].pixels[i], 5e-4);
}

TEST(ImageFile, WritesSrgbIntoAPng) {
    const ScratchFolder folder;
    // IEC 61966-2-1: 0.5 is 187.516, 0.18 is 117.65, 0.002 is 6.589 of 255.
    const Film film = grey_film({0, 0.002F, 0.18F, 0.5F, 1, 7, -1, std::numeric_limits<float>::quiet_NaN(),
                                 std::numeric_limits<float>::infinity()});
    write_image(folder.file("a.png"), film, {});
    const Film back = read_image(folder.file("a.png"));
    const std::vector<int> wanted{0, 7, 118, 188, 255, 255, 0, 0, 255};
    ASSERT_EQ(back.layers.size(), 1U);
    ASSERT_EQ(back.layers[0].channels, 3);
    for (std::size_t i = 0; i < wanted.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(std::lround(back.layers[0].pixels[3 * i + c] * 255), wanted[i]) << i;
}

TEST(ImageFile, ScalesByTheExposureBeforeEncoding) {
    const ScratchFolder folder;
    write_image(folder.file("a.png"), grey_film({0.125F}), {.exposure = 2});
    EXPECT_EQ(std::lround(read_image(folder.file("a.png")).layers[0].pixels[0] * 255), 188);
    write_image(folder.file("a.exr"), grey_film({0.125F}), {.exposure = 2});
    EXPECT_EQ(read_image(folder.file("a.exr")).layers[0].pixels[0], 0.125F);
}

TEST(ImageFile, SrgbCurvesAreInverse) {
    for (int i = 0; i <= 1000; ++i) {
        const float x = static_cast<float>(i) / 1000;
        EXPECT_NEAR(srgb_decode(srgb_encode(x)), x, 2e-6);
    }
}

TEST(ImageFile, GoesThroughEveryFormat) {
    for (const char* extension : {"png", "jpg", "jpeg", "tga", "bmp", "ppm", "webp", "exr", "hdr"}) {
        const ScratchFolder folder;
        const std::string path = folder.file(std::string("a.") + extension);
        Film film{32, 16, {{"", 3, std::vector<float>(32 * 16 * 3, 0.5F)}}};
        check_image_path(path);
        write_image(path, film, {});
        const Film back = read_image(path);
        ASSERT_EQ(back.width, 32) << extension;
        ASSERT_EQ(back.height, 16) << extension;
        const bool linear = extension == std::string("exr") || extension == std::string("hdr");
        EXPECT_NEAR(back.layers[0].pixels[100], linear ? 0.5 : 188.0 / 255, 0.01) << extension;
        EXPECT_EQ(folder.count(), 1U);
    }
}

TEST(ImageFile, PutsLayersOfAPngIntoFilesBesideIt) {
    const ScratchFolder folder;
    write_image(folder.file("out.v1.png"), sample_film(), {});
    for (const char* name :
         {"out.v1.png", "out.v1.direct.png", "out.v1.normal.png", "out.v1.depth.png", "out.v1.region.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.file(name))) << name;
    EXPECT_EQ(folder.count(), 5U);
}

TEST(ImageFile, CarriesMetadata) {
    const Metadata wanted{{"cardioid:version", "0.1.0"}, {"cardioid:command", "render a.csg -o \"b c.png\": x"}};
    for (const char* extension : {"png", "jpg", "exr"}) {
        const ScratchFolder folder;
        const std::string path = folder.file(std::string("a.") + extension);
        write_image(path, grey_film({0.5F}), {.metadata = wanted});
        Metadata found;
        static_cast<void>(read_image(path, &found));
        for (const auto& entry : wanted)
            EXPECT_NE(std::find(found.begin(), found.end(), entry), found.end()) << extension << ' ' << entry.first;
    }
}

TEST(ImageFile, NamesTheNearestExtension) {
    const ScratchFolder folder;
    EXPECT_NE(error_of([&] { check_image_path(folder.file("a.pgn")); }, ErrorCode::usage).find("did you mean \".png\""),
              std::string::npos);
    error_of([&] { check_image_path(folder.file("picture")); }, ErrorCode::usage);
    error_of([&] { check_image_path(folder.file("v1.0/picture")); }, ErrorCode::usage);
    check_image_path(folder.file("A.PNG"));
}

TEST(ImageFile, SaysWhereItCannotBeWrittenBeforeAnyWork) {
    const ScratchFolder folder;
    const std::string message = error_of([&] { check_image_path(folder.file("none/a.png")); }, ErrorCode::io);
    EXPECT_NE(message.find("none/a.png"), std::string::npos);
    std::filesystem::create_directory(folder.file("b.png"));
    error_of([&] { check_image_path(folder.file("b.png")); }, ErrorCode::io);
}

TEST(ImageFile, LoadsItsFormatsOnceForAllWhoWait) {
    std::vector<std::thread> waiting;
    for (int i = 0; i < 8; ++i) waiting.emplace_back(check_image_formats);
    for (std::thread& thread : waiting) thread.join();
    EXPECT_NO_THROW(check_image_formats());
}

TEST(ImageFile, TellsOfAFullDisk) {
    const ScratchFolder folder;
    for (const char* name : {"a.png", "a.exr", "a.jpg"}) {
        std::filesystem::create_symlink("/dev/full", folder.file(name));
        error_of([&] { write_image(folder.file(name), sample_film(), {}); }, ErrorCode::io);
    }
}

TEST(ImageFile, RefusesToReadWhatIsNoPicture) {
    const ScratchFolder folder;
    test::write_text(folder.file("a.png"), "no picture at all");
    error_of([&] { static_cast<void>(read_image(folder.file("a.png"))); }, ErrorCode::io);
    error_of([&] { static_cast<void>(read_image(folder.file("missing.png"))); }, ErrorCode::io);
    error_of([&] { static_cast<void>(read_image(folder.file("a.xyz"))); }, ErrorCode::io);
}

TEST(ImageFile, RefusesATruncatedPicture) {
    const ScratchFolder folder;
    Film film{64, 64, {{"", 3, {}}}};
    for (int i = 0; i < 64 * 64 * 3; ++i) film.layers[0].pixels.push_back(static_cast<float>((i * 7919) % 1000) / 1000);
    for (const char* name : {"a.exr", "a.png"}) {
        write_image(folder.file(name), film, {});
        const std::string whole = test::read_text(folder.file(name));
        test::write_text(folder.file(name), whole.substr(0, whole.size() / 2));
        error_of([&] { static_cast<void>(read_image(folder.file(name))); }, ErrorCode::io);
    }
}

}  // namespace
}  // namespace cardioid

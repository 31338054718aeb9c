#include <gtest/gtest.h>

#include "rt_core/image/image_file.hpp"
#include "tests/photon_module/lit_scenes.hpp"

namespace cardioid::test {
namespace {

/// Mean of all channels over the pixels x0 <= x < x1, y0 <= y < y1.
double mean_of(const Film& film, int x0, int y0, int x1, int y1) {
    double sum = 0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            for (int c = 0; c < 3; ++c)
                sum += double{film.layers[0].pixels[static_cast<std::size_t>((y * film.width + x) * 3 + c)]};
    return sum / ((x1 - x0) * (y1 - y0) * 3);
}

Film drawn(const Folder& folder, const std::string& scene, const std::vector<std::string>& more) {
    std::vector<std::string> words{scene, "-o", folder.path("a.exr").string()};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = folder.call(words);
    EXPECT_EQ(run.status, 0) << run.err;
    return read_image(folder.path("a.exr").string());
}

// What faces a shadow reads places in it, and in the shadow light is dim and what is close is bright: discs of photons
// are too wide there, and places that follow light too few (together 7 % too bright).
TEST(DarkPlaces, OfTheCornellBoxAreAsDarkAsTheReference) {
    const Folder folder;
    const std::filesystem::path box = std::filesystem::path(CARDIOID_SOURCE_DIR) / "samples/cornell";
    const Film reference = read_image((box / "block_blocks.exr").string());
    // One picture scatters by 1.2 %: two of them.
    double sum = 0;
    for (const char* const seed : {"0", "1"}) {
        const Film film = drawn(folder, (box / "block.csg").string(),
                                {"--photons=150000", "--spp", "4", "--crop", "304,424,368,472", "--seed", seed});
        ASSERT_EQ(film.width, 64);
        sum += mean_of(film, 0, 0, 64, 48);
    }
    EXPECT_NEAR(sum / 2 / mean_of(reference, 38, 53, 46, 59), 1, 0.02);
}

}  // namespace
}  // namespace cardioid::test

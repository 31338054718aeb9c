#include "rt_core/image/compare/flip.hpp"

#include <gtest/gtest.h>
#include <numeric>

namespace cardioid {
namespace {

using Pixels = std::vector<Rgb>;

double mean(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Pixels even(Rgb colour, std::size_t n = 64 * 64) { return Pixels(n, colour); }

TEST(Flip, OfAPictureWithItselfIsZero) {
    Pixels picture;
    for (int i = 0; i < 64 * 64; ++i)
        picture.emplace_back(static_cast<float>(i % 64) / 64, static_cast<float>(i / 64) / 64,
                             static_cast<float>(i % 7) / 7);
    for (const float f : flip(picture, picture, 64)) EXPECT_EQ(f, 0);
}

/// Lightness 0 and 100: HyAB 100; green and blue with Hunt's adjustment are 203.4 apart (section 4.2 of the paper).
TEST(Flip, OfWhiteAndBlackIsThatOfThePaper) { EXPECT_NEAR(mean(flip(even(Rgb(1)), even(Rgb(0)), 64)), 0.9670, 5e-4); }

TEST(Flip, OfGreenAndBlueIsTheLargestThereIs) {
    EXPECT_NEAR(mean(flip(even({0, 1, 0}), even({0, 0, 1}), 64)), 1, 1e-5);
}

TEST(Flip, GrowsWithTheDifferenceAndTakesEitherPictureForTheReference) {
    const double little = mean(flip(even(Rgb(0.5F)), even(Rgb(0.52F)), 64));
    const double more = mean(flip(even(Rgb(0.5F)), even(Rgb(0.6F)), 64));
    EXPECT_GT(little, 0);
    EXPECT_GT(more, 2 * little);
    EXPECT_NEAR(mean(flip(even(Rgb(0.6F)), even(Rgb(0.5F)), 64)), more, 1e-6);
}

/// A fine pattern and its mean look the same from afar, but the pattern has edges: seen from close by it is another
/// picture.
TEST(Flip, SeesAFinePatternFromCloseByOnly) {
    Pixels pattern;
    for (int i = 0; i < 64 * 64; ++i) pattern.emplace_back((i + i / 64) % 2 == 0 ? 0.4F : 0.6F);
    const double close = mean(flip(even(Rgb(0.5F)), pattern, 64, 10)),
                 far = mean(flip(even(Rgb(0.5F)), pattern, 64, 120));
    EXPECT_GT(close, 3 * far);
}

/// Off an edge nothing is different, but at it lightness is: a moved edge is seen along the edge alone.
TEST(Flip, FindsAMovedEdgeWhereItIs) {
    Pixels at_32, at_34;
    for (int i = 0; i < 64 * 64; ++i) {
        at_32.emplace_back(i % 64 < 32 ? 0.1F : 0.8F);
        at_34.emplace_back(i % 64 < 34 ? 0.1F : 0.8F);
    }
    const std::vector<float> found = flip(at_32, at_34, 64);
    const std::size_t row = 20 * 64;
    EXPECT_GT(found[row + 33], 0.5F);
    EXPECT_LT(found[row + 2], 1e-3F);
    EXPECT_LT(found[row + 61], 1e-3F);
}

TEST(Flip, CutsOffWhatNoDisplayShows) {
    EXPECT_EQ(mean(flip(even(Rgb(1)), even(Rgb(7)), 64)), 0);
    EXPECT_EQ(mean(flip(even(Rgb(0)), even(Rgb(-1)), 64)), 0);
}

}  // namespace
}  // namespace cardioid

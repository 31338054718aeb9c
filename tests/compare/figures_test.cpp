#include <gtest/gtest.h>

#include "rt_core/api/error.hpp"
#include "rt_core/image/compare/compare.hpp"
#include "rt_core/image/compare/edges.hpp"

namespace cardioid {
namespace {

Picture even(Rgb colour, int width = 20, int height = 10) {
    Picture p{"even", width, height, 3, false, {}, {}, {}};
    p.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), colour);
    return p;
}

TEST(Figures, OfEqualPicturesAreZero) {
    const RegionFigures f = compare(even({0.2F, 0.4F, 0.6F}), even({0.2F, 0.4F, 0.6F}), {}).whole;
    EXPECT_EQ(f.pixels, 200U);
    EXPECT_EQ(f.bias, 0);
    EXPECT_EQ(f.rmse, 0);
    EXPECT_EQ(f.relative_mse, 0);
    EXPECT_EQ(f.max, 0);
    EXPECT_EQ(f.beyond, 0);
    EXPECT_EQ(f.flip, 0);
    EXPECT_FALSE(f.z);
}

/// 0.5 against 0.4: bias 0.25, difference 0.1, relative (0.1)^2 / (0.4^2 + 0.04^2).
TEST(Figures, OfAnEvenDifferenceAreThoseByHand) {
    const RegionFigures f = compare(even(Rgb(0.5F)), even(Rgb(0.4F)), {}).whole;
    EXPECT_NEAR(f.bias, 0.25, 1e-6);
    EXPECT_NEAR(f.rmse, 0.1, 1e-7);
    EXPECT_NEAR(f.relative_mse, 0.01 / (0.16 + 0.0016), 1e-6);
    EXPECT_NEAR(f.p999, 0.1, 1e-7);
    EXPECT_EQ(f.beyond, 1);
}

TEST(Figures, TellTheLargestDifferenceAndItsPlace) {
    Picture a = even(Rgb(0.5F));
    a.pixels[3 * 20 + 7].g = 0.9F;
    const RegionFigures f = compare(a, even(Rgb(0.5F)), {}).whole;
    EXPECT_NEAR(f.max, 0.4, 1e-6);
    EXPECT_EQ(f.max_x, 7);
    EXPECT_EQ(f.max_y, 3);
    EXPECT_DOUBLE_EQ(f.beyond, 1.0 / 200);
    EXPECT_NEAR(f.rmse, std::sqrt(0.16 / 600), 1e-6);
}

TEST(Figures, OfRegionsAreOfTheirPixelsAlone) {
    Picture a = even(Rgb(0.5F));
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x) a.pixels[static_cast<std::size_t>(y * 20 + x)] = Rgb(0.6F);
    CompareSettings settings;
    settings.regions = {{"left", 0, 0, 10, 10}, {"right", 10, 0, 20, 10}};
    const Comparison c = compare(a, even(Rgb(0.5F)), settings);
    EXPECT_NEAR(c.regions[0].bias, 0.2, 1e-6);
    EXPECT_EQ(c.regions[1].bias, 0);
    EXPECT_NEAR(c.whole.bias, 0.1, 1e-6);
}

TEST(Figures, RefuseARegionOutsideThePicture) {
    CompareSettings settings;
    settings.regions = {{"far", 0, 0, 30, 5}};
    EXPECT_THROW(static_cast<void>(compare(even(Rgb(1)), even(Rgb(1)), settings)), Error);
}

/// The mean of 200 pixels of variance 0.01 each (three channels alike make a third of it) is 0.1/sqrt(3)/sqrt(200)
/// sure.
TEST(Figures, CountStandardErrorsWhereVariancesAreKnown) {
    Picture a = even(Rgb(0.51F));
    a.layers.push_back({"variance", 3, std::vector<float>(600, 0.01F)});
    const RegionFigures f = compare(a, even(Rgb(0.5F)), {}).whole;
    ASSERT_TRUE(f.z);
    EXPECT_NEAR(*f.z, 0.01 / (0.1 / std::sqrt(600.0)), 1e-3);
}

TEST(Figures, CountPixelsThatAreNotFiniteAndLeaveThemOut) {
    Picture a = even(Rgb(0.5F));
    a.pixels[25].b = std::numeric_limits<float>::quiet_NaN();
    const Comparison c = compare(a, even(Rgb(0.5F)), {});
    EXPECT_EQ(c.bad, 1U);
    EXPECT_EQ(c.first_bad, (std::array{5, 1}));
    EXPECT_EQ(c.whole.pixels, 199U);
    EXPECT_EQ(c.whole.max, 0);
}

TEST(Figures, LeaveOutEdgesOfTheLayersThatTellThem) {
    Picture a = even(Rgb(0.5F)), b = even(Rgb(0.5F));
    Layer region{"region", 1, std::vector<float>(200)};
    for (int y = 0; y < 10; ++y)
        for (int x = 10; x < 20; ++x) region.pixels[static_cast<std::size_t>(y * 20 + x)] = 1;
    a.layers.push_back(region);
    a.pixels[4 * 20 + 10] = Rgb(3);
    CompareSettings settings;
    EXPECT_GT(compare(a, b, settings).whole.max, 2);
    settings.skip_edges = true;
    const Comparison c = compare(a, b, settings);
    EXPECT_EQ(c.whole.max, 0);
    EXPECT_EQ(c.skipped, 20U);
    EXPECT_THROW(static_cast<void>(compare(b, b, settings)), Error);
}

TEST(Mismatch, NamesSizesAndChannels) {
    EXPECT_EQ(mismatch(even(Rgb(1)), even(Rgb(1))), "");
    EXPECT_NE(mismatch(even(Rgb(1)), even(Rgb(1), 21)).find("21x10"), std::string::npos);
    Picture grey = even(Rgb(1));
    grey.channels = 1;
    EXPECT_NE(mismatch(even(Rgb(1)), grey).find("grey"), std::string::npos);
    Picture alpha = even(Rgb(1));
    alpha.channels = 4;
    alpha.alpha.assign(200, 1.0F);
    EXPECT_EQ(mismatch(even(Rgb(1)), alpha), "");
    alpha.alpha[7] = 0.5F;
    EXPECT_NE(mismatch(even(Rgb(1)), alpha).find("alpha"), std::string::npos);
}

}  // namespace
}  // namespace cardioid

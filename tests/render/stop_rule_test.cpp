#include "rt_core/render/stop_rule.hpp"

#include <gtest/gtest.h>

#include "rt_core/math/sampler.hpp"

namespace cardioid {
namespace {

TEST(PassPlan, TakesExactlyTheSamplesAskedFor) {
    for (const int samples : {1, 2, 3, 31, 32, 100}) {
        RenderSettings settings;
        settings.samples = samples;
        const PassPlan plan(settings);
        std::uint32_t done = 0;
        while (const std::uint32_t n = plan.next(done)) done += n;
        EXPECT_EQ(done, static_cast<std::uint32_t>(samples));
        EXPECT_EQ(plan.share(done), 1);
        EXPECT_FALSE(plan.time_is_up());
    }
}

TEST(PassPlan, GrowsEvenPassesWhereNoiseEndsARender) {
    for (const int samples : {0, 7, 100}) {
        RenderSettings settings;
        settings.samples = samples;
        settings.noise = 0.02;
        const PassPlan plan(settings);
        std::uint32_t done = 0;
        while (const std::uint32_t n = done < 10'000 ? plan.next(done) : 0) {
            EXPECT_EQ(n % 2, 0U);
            EXPECT_LE(n, std::max(8U, done / 8 + 2));
            done += n;
        }
        if (samples > 0) EXPECT_EQ(done, static_cast<std::uint32_t>(samples + samples % 2));
    }
}

/// A tile of 256 pixels with samples even in [0, 2): mean 1, standard deviation 1 / sqrt(3); half of them are the first
/// sequence's.
bool quiet_tile(double limit, std::uint32_t samples, std::size_t pixels = 256) {
    NoiseMeter meter(limit, pixels);
    std::vector<NoiseMeter::Sum> tile;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        float sum = 0;
        for (std::uint32_t s = 0; s < samples; ++s) {
            const float L = 2 * unit_float(static_cast<std::uint32_t>(mix64(pixel << 32 | s)));
            if (s < samples / 2) meter.add(pixel, L);
            sum += L;
        }
        tile.push_back({pixel, sum});
    }
    return meter.quiet(tile, samples, 1);
}

TEST(NoiseMeter, MeasuresTheStandardErrorOfPixels) {
    constexpr std::uint32_t samples = 128;
    const double error = 1 / std::sqrt(3.0 * samples);
    EXPECT_TRUE(quiet_tile(1.15 * error, samples));
    EXPECT_FALSE(quiet_tile(0.85 * error, samples));
}

TEST(NoiseMeter, AsksMoreOfFewPixels) {
    EXPECT_TRUE(quiet_tile(10, 8));
    EXPECT_FALSE(quiet_tile(10, 8, 16));
    EXPECT_TRUE(quiet_tile(10, 128, 16));
}

TEST(NoiseMeter, LetsBlackTilesEnd) {
    NoiseMeter meter(0.01, 1);
    const NoiseMeter::Sum black{0, 0};
    EXPECT_TRUE(meter.quiet({&black, 1}, 2048, 1));
    EXPECT_TRUE(meter.quiet({&black, 1}, 2048, 0));
}

}  // namespace
}  // namespace cardioid

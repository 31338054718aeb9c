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

TEST(NoiseMeter, MeasuresTheStandardErrorOfPixels) {
    // Samples even in [0, 2): mean 1, standard deviation 1 / sqrt(3), so n samples err by 1 / sqrt(3 n).
    constexpr std::uint32_t pass_samples = 8, passes = 16;
    const double error = 1 / std::sqrt(3.0 * pass_samples * passes);
    std::vector<std::size_t> pixels;
    for (std::size_t i = 0; i < 256; ++i) pixels.push_back(i);
    const auto quiet = [&](double limit) {
        NoiseMeter meter(limit, pixels.size());
        for (const std::size_t pixel : pixels) {
            float sum = 0;
            for (std::uint32_t s = 0; s < passes * pass_samples; ++s) {
                sum += 2 * unit_float(static_cast<std::uint32_t>(mix64(pixel << 32 | s)));
                if (s % pass_samples == pass_samples - 1) meter.add_pass(pixel, sum, pass_samples);
            }
        }
        return meter.quiet(pixels, passes, pass_samples, 1);
    };
    EXPECT_TRUE(quiet(1.05 * error));
    EXPECT_FALSE(quiet(0.95 * error));
}

TEST(NoiseMeter, LetsBlackTilesEnd) {
    NoiseMeter meter(0.01, 1);
    for (int pass = 0; pass < 4; ++pass) meter.add_pass(0, 0, 8);
    EXPECT_TRUE(meter.quiet({0}, 4, 8, 1));
    EXPECT_FALSE(meter.quiet({0}, 3, 8, 1));
}

}  // namespace
}  // namespace cardioid

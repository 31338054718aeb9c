#include "rt_core/render/stop_rule.hpp"

#include <gtest/gtest.h>

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
        EXPECT_EQ(plan.share(done, 0), 1);
        EXPECT_EQ(plan.share(0, 0.25), 0.25);
        EXPECT_FALSE(plan.time_is_up());
    }
}

TEST(PassPlan, TakesPairsWhereNoiseEndsARender) {
    RenderSettings settings;
    settings.samples = 7;
    EXPECT_EQ(PassPlan(settings).most_samples(), 7U);
    settings.noise = 0.02;
    EXPECT_EQ(PassPlan(settings).most_samples(), 8U);
}

}  // namespace
}  // namespace cardioid

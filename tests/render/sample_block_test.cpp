#include <gtest/gtest.h>

#include "rt_core/render/sampling/pixel_stream.hpp"

namespace cardioid {
namespace {

TEST(SampleBlock, GivesTheNumbersOfSingleSamplersOnEveryProcessor) {
    for (const SampleBlock::Fill fill : {fill_samples(), SampleBlock::Fill{fill_samples_plain}}) {
        SampleBlock block(fill);
        for (const std::uint32_t first : {0U, 3U, 4'000'000'000U}) {
            block.begin(7, Purpose::camera, 123'456'789, first);
            for (std::uint32_t lane = 0; lane < SampleBlock::samples; ++lane) {
                Sampler together(block, lane), alone(7, Purpose::camera, 123'456'789, first + lane);
                for (std::uint32_t i = 0; i < SampleBlock::pairs + 5; ++i) ASSERT_EQ(together.next2(), alone.next2());
                EXPECT_EQ(together, alone);
            }
        }
    }
}

TEST(PixelStream, IsOneSequencePassAfterPass) {
    PixelStream stream(1, false);
    std::uint32_t sample = 0;
    for (const std::uint32_t count : {1U, 2U, 16U, 40U}) {
        stream.begin(9, sample, count);
        for (std::uint32_t i = 0; i < count; ++i, ++sample)
            EXPECT_EQ(stream.next().next2(), Sampler(1, Purpose::camera, 9, sample).next2());
    }
}

TEST(PixelStream, IsTwoSequencesHalfAndHalfWhereAskedFor) {
    PixelStream stream(1, true);
    std::uint32_t done = 0;
    for (const std::uint32_t count : {8U, 2U, 40U}) {
        stream.begin(9, done, count);
        for (const std::uint64_t pixel : {std::uint64_t{9}, std::uint64_t{9} | std::uint64_t{1} << 63})
            for (std::uint32_t i = 0; i < count / 2; ++i)
                EXPECT_EQ(stream.next().next2(), Sampler(1, Purpose::camera, pixel, done / 2 + i).next2());
        done += count;
    }
}

}  // namespace
}  // namespace cardioid

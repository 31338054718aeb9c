#pragma once
#include "rt_core/render/sampling/fill_samples.hpp"

namespace cardioid {

/// The numbers of one pixel's pass, sample by sample: of one sequence, or half of each of two that are independent.
class PixelStream {
public:
    PixelStream(std::uint32_t seed, bool two) : seed_(seed), two_(two), block_(fill_samples) {}

    /// Turns to a pass of `count` samples after `first`; both even where there are two sequences.
    void begin(std::uint64_t pixel, std::uint32_t first, std::uint32_t count) {
        pixel_ = pixel, at_ = 0;
        each_ = two_ ? count / 2 : count;
        first_ = two_ ? first / 2 : first;
    }
    /// Numbers for the next sample; good until the one after it.
    Sampler next() {
        const std::uint32_t of_sequence = at_ % each_, lane = of_sequence % SampleBlock::samples;
        if (lane == 0) {
            const std::uint64_t sequence = at_ / each_;
            block_.begin(seed_, Purpose::camera, pixel_ | sequence << 63, first_ + of_sequence);
        }
        ++at_;
        return {block_, lane};
    }

private:
    std::uint32_t seed_;
    bool two_;
    SampleBlock block_;
    std::uint64_t pixel_ = 0;
    std::uint32_t at_ = 0, each_ = 1, first_ = 0;
};

}  // namespace cardioid

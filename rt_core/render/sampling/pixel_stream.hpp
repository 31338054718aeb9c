#pragma once
#include "rt_core/math/fill_samples.hpp"

namespace cardioid {

/// The numbers of one pixel's pass, sample by sample: of one sequence, or half of each of two that are independent.
class PixelStream {
public:
    PixelStream(std::uint32_t seed, bool two) : seed_(seed), two_(two), block_(fill_samples()) {}

    /// Turns to a pass of `count` samples after `first`; both even where there are two sequences.
    void begin(std::uint64_t pixel, std::uint32_t first, std::uint32_t count) {
        pixel_ = pixel, at_ = 0;
        each_ = two_ ? count / 2 : count;
        first_ = two_ ? first / 2 : first;
    }
    /// Numbers for the next sample; good until the one after it.
    Sampler next() {
        const std::uint32_t of_sequence = at_ % each_, lane = of_sequence % SampleBlock::samples;
        const std::uint64_t index = pixel_ | std::uint64_t{at_ / each_} << 63;
        ++at_;
        if (each_ <= few) return {seed_, Purpose::camera, index, first_ + of_sequence};
        if (lane == 0) block_.begin(seed_, Purpose::camera, index, first_ + of_sequence);
        return {block_, lane};
    }

private:
    /// A block works out the numbers of sixteen samples, which so many by themselves are quicker than.
    static constexpr std::uint32_t few = 2;

    std::uint32_t seed_;
    bool two_;
    SampleBlock block_;
    std::uint64_t pixel_ = 0;
    std::uint32_t at_ = 0, each_ = 1, first_ = 0;
};

}  // namespace cardioid

#pragma once
#include "rt_core/math/sampler.hpp"

namespace cardioid {

/// The quickest way this processor has to fill a SampleBlock; the numbers are the same everywhere, they are integers.
extern const SampleBlock::Fill fill_samples;
/// The way that every processor has.
void fill_samples_plain(const detail::PairSeeds* seeds, const std::uint32_t* reversed, float* out);

}  // namespace cardioid

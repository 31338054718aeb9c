#pragma once
#include "rt_core/math/sampler.hpp"

namespace cardioid {

namespace detail {

/// A loop that compilers turn into vector instructions of whatever the caller is compiled for.
[[gnu::always_inline]] inline void fill_samples_inline(const PairSeeds* seeds, const std::uint32_t* reversed,
                                                       float* out) {
    constexpr std::uint32_t n = SampleBlock::samples;
    // As unit_float, by way of a signed number, for which there is an instruction; 24 bits fit.
    const auto fraction = [](std::uint32_t bits) __attribute__((always_inline)) {
        return static_cast<float>(static_cast<std::int32_t>(bits >> 8)) * 0x1p-24F;
    };
    // Both pairs in one turn: each is a chain of multiplications, and the chains run side by side.
    for (std::uint32_t i = 0; i < n; ++i) {
        const PairBits a = sobol_pair(seeds[0], reversed[i]);
        const PairBits b = sobol_pair(seeds[1], reversed[i]);
        out[i] = fraction(a.x), out[n + i] = fraction(a.y);
        out[2 * n + i] = fraction(b.x), out[3 * n + i] = fraction(b.y);
    }
}

}  // namespace detail

/// Fills a SampleBlock in the way that every processor has.
inline void fill_samples_plain(const detail::PairSeeds* seeds, const std::uint32_t* reversed, float* out) {
    detail::fill_samples_inline(seeds, reversed, out);
}

#if defined(__x86_64__)
namespace detail {

__attribute__((target("avx512f,avx512bw"))) inline void fill_samples_avx512(const PairSeeds* seeds,
                                                                            const std::uint32_t* reversed, float* out) {
    fill_samples_inline(seeds, reversed, out);
}
__attribute__((target("avx2"))) inline void fill_samples_avx2(const PairSeeds* seeds, const std::uint32_t* reversed,
                                                              float* out) {
    fill_samples_inline(seeds, reversed, out);
}

}  // namespace detail
#endif

/// The quickest way this processor has to fill a SampleBlock; the numbers are the same everywhere, they are integers.
inline SampleBlock::Fill fill_samples() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw")) return detail::fill_samples_avx512;
    if (__builtin_cpu_supports("avx2")) return detail::fill_samples_avx2;
#endif
    return fill_samples_plain;
}

}  // namespace cardioid

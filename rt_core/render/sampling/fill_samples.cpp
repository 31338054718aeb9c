#include "rt_core/render/sampling/fill_samples.hpp"

namespace cardioid {

namespace {

/// As unit_float, by way of a signed number, for which there is an instruction; 24 bits fit.
[[gnu::always_inline]] inline float fraction(std::uint32_t bits) {
    return static_cast<float>(static_cast<std::int32_t>(bits >> 8)) * 0x1p-24F;
}

/// A loop that compilers turn into vector instructions of whatever the caller is compiled for.
[[gnu::always_inline]] inline void fill(const detail::PairSeeds* seeds, const std::uint32_t* reversed, float* out) {
    constexpr std::uint32_t n = SampleBlock::samples;
    // Both pairs in one turn: each is a chain of multiplications, and the chains run side by side.
    for (std::uint32_t i = 0; i < n; ++i) {
        const detail::PairBits a = detail::sobol_pair(seeds[0], reversed[i]);
        const detail::PairBits b = detail::sobol_pair(seeds[1], reversed[i]);
        out[i] = fraction(a.x), out[n + i] = fraction(a.y);
        out[2 * n + i] = fraction(b.x), out[3 * n + i] = fraction(b.y);
    }
}

}  // namespace

void fill_samples_plain(const detail::PairSeeds* seeds, const std::uint32_t* reversed, float* out) {
    fill(seeds, reversed, out);
}

#if defined(__x86_64__)
namespace {

__attribute__((target("avx512f,avx512bw"))) void fill_avx512(const detail::PairSeeds* seeds,
                                                             const std::uint32_t* reversed, float* out) {
    fill(seeds, reversed, out);
}
__attribute__((target("avx2"))) void fill_avx2(const detail::PairSeeds* seeds, const std::uint32_t* reversed,
                                               float* out) {
    fill(seeds, reversed, out);
}

SampleBlock::Fill quickest() {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw")) return fill_avx512;
    return __builtin_cpu_supports("avx2") ? fill_avx2 : fill_samples_plain;
}

}  // namespace
const SampleBlock::Fill fill_samples = quickest();
#else
const SampleBlock::Fill fill_samples = fill_samples_plain;
#endif

}  // namespace cardioid

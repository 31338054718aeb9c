#pragma once
#include <array>
#include <cstdint>

#include "rt_core/math/vec.hpp"

namespace cardioid {

/// What random numbers are drawn for; two purposes never share a sequence.
enum class Purpose : std::uint32_t { camera, photons, gather, cache, statistics, test };

/// Mixes 64 bits so that every input bit changes every output bit (Steele et al. 2014, SplitMix64's finaliser).
constexpr std::uint64_t mix64(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15ULL;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
    return x ^ (x >> 31);
}

/// The top 24 bits as a float in [0, 1).
constexpr float unit_float(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24F; }

namespace detail {

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
    x = (x << 16) | (x >> 16);
    x = ((x & 0x00FF00FFU) << 8) | ((x & 0xFF00FF00U) >> 8);
    x = ((x & 0x0F0F0F0FU) << 4) | ((x & 0xF0F0F0F0U) >> 4);
    x = ((x & 0x33333333U) << 2) | ((x & 0xCCCCCCCCU) >> 2);
    return ((x & 0x55555555U) << 1) | ((x & 0xAAAAAAAAU) >> 1);
}

/// Owen scrambling of a bit-reversed fraction (Laine, Karras 2011; constants of Burley 2020, section 4).
constexpr std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3D20ADEAU;
    x += seed;
    x *= (seed >> 16) | 1;
    x ^= x * 0x05526C56U;
    x ^= x * 0x53A22864U;
    return x;
}

/// The second dimension of Sobol's sequence, a byte of the index at a time: column j of its
/// generator is Pascal's triangle modulo 2, v[0] = 2^31, v[j] = v[j-1] ^ (v[j-1] >> 1).
constexpr auto sobol_second_table() {
    std::array<std::array<std::uint32_t, 256>, 4> table{};
    std::uint32_t column = 0x80000000U;
    for (std::size_t bit = 0; bit < 32; ++bit, column ^= column >> 1)
        for (std::size_t value = 0; value < 256; ++value)
            if (value >> (bit % 8) & 1) table[bit / 8][value] ^= column;
    return table;
}
inline constexpr auto sobol_second = sobol_second_table();

}  // namespace detail

/// Random numbers that depend on (seed, purpose, index, sample, dimension) alone, so that a picture does not
/// depend on threads: Sobol's first two dimensions, padded, each pair shuffled and Owen-scrambled anew
/// (Burley 2020, "Practical Hash-based Owen Scrambling"). Consecutive samples of one index are well stratified.
class Sampler {
public:
    /// index: the pixel or photon; sample: its running number.
    Sampler(std::uint32_t seed, Purpose purpose, std::uint64_t index, std::uint32_t sample)
        : key_(mix64(mix64((std::uint64_t{seed} << 32) ^ static_cast<std::uint32_t>(purpose)) ^ index)),
          sample_(detail::reverse_bits(sample)) {}

    /// The next dimension, in [0, 1).
    float next() { return next2().x; }
    /// The next pair of dimensions, each in [0, 1).
    Vec2 next2() {
        const std::uint64_t a = mix64(key_ + dimension_), b = mix64(a);
        ++dimension_;
        // Scrambling the reversed index shuffles the order of the points, which keeps padded pairs independent.
        const std::uint32_t shuffled = detail::scramble_reversed(sample_, static_cast<std::uint32_t>(a));
        const std::uint32_t index = detail::reverse_bits(shuffled);
        const std::uint32_t second = detail::sobol_second[0][index & 255] ^ detail::sobol_second[1][index >> 8 & 255] ^
                                     detail::sobol_second[2][index >> 16 & 255] ^ detail::sobol_second[3][index >> 24];
        return {unit_float(scrambled(index, static_cast<std::uint32_t>(a >> 32))),
                unit_float(scrambled(detail::reverse_bits(second), static_cast<std::uint32_t>(b)))};
    }

private:
    /// Owen-scrambles the fraction whose reversed bits are given.
    static std::uint32_t scrambled(std::uint32_t reversed, std::uint32_t seed) {
        return detail::reverse_bits(detail::scramble_reversed(reversed, seed));
    }

    std::uint64_t key_;
    std::uint32_t sample_;  ///< bit-reversed
    std::uint32_t dimension_ = 0;
};

}  // namespace cardioid

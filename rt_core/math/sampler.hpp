#pragma once
#include <cstdint>

#include "rt_core/math/vec.hpp"

namespace cardioid {

/// What random numbers are drawn for; two purposes never share a sequence.
enum class Purpose : std::uint32_t { camera, photons, gather, cache, statistics, test, probe, ledger };

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
    x = __builtin_bswap32(x);
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

/// The second dimension of Sobol's sequence, bit-reversed. Column j of its generator is Pascal's triangle modulo 2: bit
/// i is the sum modulo 2 of the index's bits j whose binary digits contain those of i (Lucas 1878), digit by digit.
constexpr std::uint32_t sobol_second(std::uint32_t index) {
    index ^= index >> 1 & 0x55555555U;
    index ^= index >> 2 & 0x33333333U;
    index ^= index >> 4 & 0x0F0F0F0FU;
    index ^= index >> 8 & 0x00FF00FFU;
    return index ^ (index >> 16 & 0x0000FFFFU);
}

/// What scrambles one pair of dimensions of one index.
struct PairSeeds {
    std::uint32_t order, x, y;
    constexpr explicit PairSeeds(std::uint64_t key) : order(0), x(0), y(0) {
        const std::uint64_t a = mix64(key), b = mix64(a);
        order = static_cast<std::uint32_t>(a), x = static_cast<std::uint32_t>(a >> 32);
        y = static_cast<std::uint32_t>(b);
    }
};

/// Both dimensions of the pair for the sample whose number is given bit-reversed, each as 32 bits of a fraction.
/// Scrambling the reversed number shuffles the order of the points, which keeps padded pairs independent.
struct PairBits {
    std::uint32_t x, y;
};
constexpr PairBits sobol_pair(const PairSeeds& seeds, std::uint32_t reversed_sample) {
    const std::uint32_t index = reverse_bits(scramble_reversed(reversed_sample, seeds.order));
    return {reverse_bits(scramble_reversed(index, seeds.x)),
            reverse_bits(scramble_reversed(sobol_second(index), seeds.y))};
}

}  // namespace detail

/// The first dimensions of sixteen samples in a row of one index, as Sampler would give them one by one but worked out
/// together, each two pairs when they are first asked for. Belongs to one thread.
class SampleBlock {
public:
    static constexpr std::uint32_t samples = 16, pairs = 16;
    /// Writes two pairs, x x x ... y y y ... and again, of all samples; `reversed` are their numbers, bit-reversed.
    using Fill = void (*)(const detail::PairSeeds* seeds, const std::uint32_t* reversed, float* out);

    explicit SampleBlock(Fill fill) : fill_(fill) {}
    /// Turns to the samples `first` to first + 15 of another index; see Sampler.
    void begin(std::uint32_t seed, Purpose purpose, std::uint64_t index, std::uint32_t first) {
        key_ = mix64(mix64((std::uint64_t{seed} << 32) ^ static_cast<std::uint32_t>(purpose)) ^ index);
        for (std::uint32_t i = 0; i < samples; ++i) reversed_[i] = detail::reverse_bits(first + i);
        filled_ = 0;
    }

private:
    friend class Sampler;
    Vec2 pair(std::uint32_t number, std::uint32_t sample) {
        while (number >= filled_) fill_next();
        return {x_and_y_[number][0][sample], x_and_y_[number][1][sample]};
    }
    void fill_next() {
        const detail::PairSeeds seeds[2] = {detail::PairSeeds(key_ + filled_), detail::PairSeeds(key_ + filled_ + 1)};
        fill_(seeds, reversed_, x_and_y_[filled_][0]);
        filled_ += 2;
    }

    Fill fill_;
    std::uint64_t key_ = 0;
    std::uint32_t filled_ = 0;  ///< pairs that are there; samplers ask for them in order
    alignas(64) std::uint32_t reversed_[samples];
    alignas(64) float x_and_y_[pairs][2][samples];
};

/// Random numbers that depend on (seed, purpose, index, sample, dimension) alone, so that a picture does not
/// depend on threads: Sobol's first two dimensions, padded, each pair shuffled and Owen-scrambled anew
/// (Burley 2020, "Practical Hash-based Owen Scrambling"). Consecutive samples of one index are well stratified.
class Sampler {
public:
    /// index: the pixel or photon; sample: its running number.
    Sampler(std::uint32_t seed, Purpose purpose, std::uint64_t index, std::uint32_t sample)
        : key_(mix64(mix64((std::uint64_t{seed} << 32) ^ static_cast<std::uint32_t>(purpose)) ^ index)),
          sample_(detail::reverse_bits(sample)) {}
    /// The same numbers, for sample `lane` of the block; the block must outlive it and keep its index.
    Sampler(SampleBlock& block, std::uint32_t lane)
        : key_(block.key_), sample_(block.reversed_[lane]), lane_(lane), block_(&block) {}

    /// Two that are equal give the same numbers from here on.
    constexpr bool operator==(const Sampler& other) const {
        return key_ == other.key_ && sample_ == other.sample_ && dimension_ == other.dimension_;
    }

    /// The next dimension, in [0, 1).
    float next() { return next2().x; }
    /// The next pair of dimensions, each in [0, 1).
    Vec2 next2() {
        const std::uint32_t number = dimension_++;
        if (block_ && number < SampleBlock::pairs) return block_->pair(number, lane_);
        const detail::PairBits bits = detail::sobol_pair(detail::PairSeeds(key_ + number), sample_);
        return {unit_float(bits.x), unit_float(bits.y)};
    }

private:
    std::uint64_t key_;
    std::uint32_t sample_;  ///< bit-reversed
    std::uint32_t dimension_ = 0;
    std::uint32_t lane_ = 0;
    SampleBlock* block_ = nullptr;
};

}  // namespace cardioid

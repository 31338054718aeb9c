#pragma once
#include "photon/options/choices.hpp"
#include "rt_core/api/world.hpp"

namespace cardioid::photon {

/// Passes draw their numbers from sequences of their own.
enum class Pass : std::uint32_t { pilot, global, caustic, aim };

/// The four numbers that a light makes a photon's ray from, each in [0, 1).
struct EmissionNumbers {
    Vec2 place, direction;
};

/// The numbers of photons one after the other: `stratum` is a part of a light's emission that has a low-discrepancy
/// sequence of its own. Those of sixteen neighbours are worked out together.
class PhotonStream {
public:
    PhotonStream(std::uint32_t seed, Pass pass) : seed_(seed), pass_(pass), block_(fill_samples()) {}

    /// Numbers of photon `number` of `count` in the stratum; good until the next one is asked for.
    Sampler sampler(std::uint32_t light, std::uint32_t stratum, std::uint32_t number, std::uint32_t count) {
        const std::uint64_t sequence = (std::uint64_t{light} << 32 | stratum) * 4 + static_cast<std::uint64_t>(pass_);
        if (count <= few) return {seed_, Purpose::photons, sequence, number};
        const std::uint32_t lane = number % SampleBlock::samples;
        if (sequence != sequence_ || number - lane != first_) {
            sequence_ = sequence, first_ = number - lane;
            block_.begin(seed_, Purpose::photons, sequence, first_);
        }
        return {block_, lane};
    }

private:
    /// So many by themselves are quicker than a block.
    static constexpr std::uint32_t few = 2;

    std::uint32_t seed_;
    Pass pass_;
    SampleBlock block_;
    std::uint64_t sequence_ = ~std::uint64_t{0};  ///< of the block, with the number of its first photon
    std::uint32_t first_ = 0;
};

/// Draws them: two pairs of the sampler, so that the photons of a light are stratified over place and over direction.
[[nodiscard]] EmissionNumbers draw_emission(Directions directions, Sampler& sampler) noexcept;

}  // namespace cardioid::photon

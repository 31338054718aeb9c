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

/// The sampler of a photon: `stratum` is a part of a light's emission that has a low-discrepancy sequence of its own.
[[nodiscard]] inline Sampler photon_sampler(std::uint32_t seed, Pass pass, std::uint32_t light, std::uint32_t stratum,
                                            std::uint32_t number) {
    const std::uint64_t sequence = (std::uint64_t{light} << 32 | stratum) * 4 + static_cast<std::uint64_t>(pass);
    return {seed, Purpose::photons, sequence, number};
}

/// Draws them: two pairs of the sampler, so that the photons of a light are stratified over place and over direction.
[[nodiscard]] EmissionNumbers draw_emission(Directions directions, Sampler& sampler) noexcept;

}  // namespace cardioid::photon

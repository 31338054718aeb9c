#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "rt_core/api/world.hpp"

namespace cardioid::photon {

/// Most photons of one light in one pass: the sampler numbers them in 32 bits.
inline constexpr std::uint64_t most_of_a_light = 0xFFFFFFFF;

/// Numbers in proportion to `weights` that sum to `total` exactly, by largest remainder (Hamilton); among equal
/// remainders the earlier wins. Weights >= 0; all zero gives all zero.
[[nodiscard]] std::vector<std::uint64_t> largest_remainder(std::span<const double> weights, std::uint64_t total);

/// Throws Error(limit) where one light would emit more than most_of_a_light.
void check_count_of_a_light(std::uint64_t count);

/// Sum of Light::power() [W].
[[nodiscard]] Rgb total_power(std::span<const std::unique_ptr<Light>> lights);

}  // namespace cardioid::photon

#pragma once
#include "photon/emission/aim.hpp"
#include "photon/emission/light_shares.hpp"

namespace cardioid::photon {

/// Photons of one cell of a light's emission. They have a low-discrepancy sequence of their own.
struct Batch {
    AimCell cell;
    std::uint32_t stratum = 0;  ///< names the sequence
    std::uint64_t first = 0;    ///< photons of the batches before
    std::uint32_t count = 0;    ///< above 0
    float share = 1;            ///< what LightEmission::flux is multiplied by: volume / count
};

/// All photons of a pass, batch after batch; photon i belongs to the last batch with first <= i.
struct BatchList {
    std::vector<Batch> batches;
    std::uint64_t total = 0;
};

/// A batch a light, shared out by `rule`. Throws Error(limit).
[[nodiscard]] BatchList even_batches(std::span<const std::unique_ptr<Light>> lights, std::uint64_t count, Shares rule);

/// A batch a cell, by power, volume and density; at least one photon each, so that nothing is left out. Throws
/// Error(limit).
[[nodiscard]] BatchList aimed_batches(std::span<const std::unique_ptr<Light>> lights, std::uint64_t count,
                                      const Aim& aim);

}  // namespace cardioid::photon

#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "photon/emission/emit.hpp"
#include "photon/options/photon_options.hpp"
#include "rt_core/api/progress.hpp"

namespace cardioid::photon {

/// A box of the four numbers in [0, 1) that a light makes its rays from (place x, y, direction x, y).
struct AimCell {
    std::uint32_t light = 0;
    std::array<float, 4> lo{0, 0, 0, 0}, size{1, 1, 1, 1};
    double density =
        1;  ///< photons here for each that even emission would send; above 0 everywhere, so nothing is lost

    [[nodiscard]] double volume() const {
        return double{size[0]} * double{size[1]} * double{size[2]} * double{size[3]};
    }
    [[nodiscard]] EmissionNumbers inside(const EmissionNumbers& u) const noexcept;
};

/// Where photons are worth sending: a partition of every light's emission into cells, each with a density. A photon's
/// flux is divided by the density of its cell, so that any densities give the right mean (Jensen's projection map,
/// 2001, section 5.2.2, but over the lights' own random numbers, which holds for every kind of light).
struct Aim {
    std::vector<AimCell> cells;  ///< by light
    std::uint64_t paths = 0;     ///< tried to find it
    double share = 0;            ///< of the flux of all lights that becomes caustics

    /// Nothing was found: no photon of those tried made a caustic.
    [[nodiscard]] bool empty() const { return !(share > 0); }
};

/// Finds where caustics come from by `paths` photons that are followed by mirrors and glass alone. Lights are divided
/// where caustic-making and other emission meet; densities are the square root of the share that was seen to make
/// caustics, which leaves the least variance (Rubinstein 1981, importance sampling of a known second moment).
[[nodiscard]] Aim find_aim(const World& world, const PhotonOptions& options, std::uint32_t seed, std::uint64_t paths,
                           Progress& progress);

}  // namespace cardioid::photon

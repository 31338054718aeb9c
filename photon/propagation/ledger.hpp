#pragma once
#include <array>
#include <cstdint>

#include "photon/propagation/path_class.hpp"

namespace cardioid::photon {

/// A sum of fluxes [W], per channel.
struct FluxSum {
    double r = 0, g = 0, b = 0;
    FluxSum& operator+=(const FluxSum& o) { return r += o.r, g += o.g, b += o.b, *this; }
    FluxSum& operator+=(Rgb o) { return *this += FluxSum{double{o.r}, double{o.g}, double{o.b}}; }
    FluxSum& operator-=(Rgb o) { return *this += FluxSum{-double{o.r}, -double{o.g}, -double{o.b}}; }
};

/// Where the flux of a pass went. For each channel emitted = absorbed + escaped + cut_off, but for rounding: what a
/// photon loses at a surface or in a medium is what it had less what it goes on with, be it by the roulette's choice.
/// In a pass that follows caustics alone, `absorbed` has what diffuse surfaces scatter on, too.
struct Ledger {
    FluxSum emitted, absorbed, escaped;
    FluxSum cut_off;                                    ///< of paths that ended at the safety limit or were not finite
    std::array<FluxSum, path_classes> stored;           ///< of photons kept; one path is stored many times
    std::array<std::uint64_t, path_classes> photons{};  ///< kept
    std::uint64_t paths = 0;                            ///< asked of the lights
    std::uint64_t rays = 0;                             ///< traced
    std::uint64_t specular_first = 0;                   ///< paths that met a mirror, glass or a glossy surface first
    std::uint64_t caustic_paths = 0;                    ///< paths that left a caustic photon
    std::uint64_t cut = 0;                              ///< paths that ended at the safety limit
    std::uint64_t not_finite = 0;                       ///< paths that ended because a shader gave NaN or infinity

    Ledger& operator+=(const Ledger& o);
    [[nodiscard]] std::uint64_t stored_photons() const { return photons[0] + photons[1] + photons[2]; }
    /// Largest over the channels of |emitted - absorbed - escaped - cut_off| / emitted; 0 where nothing was emitted.
    [[nodiscard]] double gap() const;
};

}  // namespace cardioid::photon

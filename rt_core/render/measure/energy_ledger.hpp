#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rt_core/api/world.hpp"

namespace cardioid {

/// W in each of the three channels, summed up in double precision.
struct Flux {
    std::array<double, 3> channel{};
    Flux& operator+=(const Flux& o) {
        for (std::size_t c = 0; c < 3; ++c) channel[c] += o.channel[c];
        return *this;
    }
    friend Flux operator+(Flux a, const Flux& b) { return a += b; }
    friend Flux operator-(Flux a, const Flux& b) {
        for (std::size_t c = 0; c < 3; ++c) a.channel[c] -= b.channel[c];
        return a;
    }
    friend Flux operator*(Flux a, double s) {
        for (double& x : a.channel) x *= s;
        return a;
    }
    [[nodiscard]] double sum() const { return channel[0] + channel[1] + channel[2]; }
};

/// What a material takes of the light.
struct MaterialFlux {
    std::string material;
    Flux received;     ///< all that met it, each time it did
    Flux absorbed;     ///< at surfaces and inside; below zero where it gives out more than it gets
    double error = 0;  ///< standard error of absorbed.sum(), W
};

/// Where the light of a scene goes: emitted = absorbed + escaped + cut off.
struct EnergyLedger {
    Flux power;    ///< of all lights as they tell it themselves, apart from the paths
    Flux emitted;  ///< by the paths; differs from `power` by the noise of lights that do not emit evenly
    Flux escaped;  ///< left the scene
    /// Russian roulette and the end of long paths: what they took less what they gave. Its mean is 0 but for paths
    /// that never lose anything (a closed room of perfect mirrors).
    Flux cut_off;
    std::vector<MaterialFlux> absorbed;  ///< in the order of World::materials(), those that light met
    std::uint64_t paths = 0;
    std::uint64_t bad_paths = 0;  ///< ended by a flux that was not finite or negative

    [[nodiscard]] Flux absorbed_in_all() const;
    /// |emitted - absorbed - escaped - cut off| over emitted, the worst channel; 0 where nothing is emitted.
    [[nodiscard]] double imbalance() const;
};

/// Follows some ten thousand light paths from the lamps to their ends and books what becomes of their flux; the lights
/// share them by their power, at least one each. Same figures for any number of threads. Flux has no factor of
/// (eta_o / eta_i)^2 at boundaries, which Bsdf has for radiance (Veach 1997, section 5.2).
EnergyLedger energy_ledger(const World& world, std::uint32_t seed, std::uint32_t paths = 1U << 15);

/// Of materials that give out more light than they get, beyond doubt (5 standard errors), and of lights whose paths
/// differ from their power by more than 1 %.
std::vector<std::string> ledger_warnings(const EnergyLedger& ledger);

}  // namespace cardioid

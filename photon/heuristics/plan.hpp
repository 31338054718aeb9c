#pragma once
#include <string>

#include "photon/emission/shoot.hpp"
#include "rt_core/api/eye.hpp"

namespace cardioid::photon {

/// A parameter as it came out, for -v and --stats.
struct Derived {
    std::string name, value, why;
};

/// Every number that nobody gave, from the scene and the picture (ARL-TR-3608, note [1]: "automate all parameters").
struct Plan {
    std::uint64_t count = 0;                ///< photons to emit for the global map
    std::uint64_t caustic_count = 0;        ///< for the caustic map; 0: there are no caustics, or none are wanted
    std::uint32_t k = 0, caustic_k = 0;     ///< photons of a lookup
    double radius = 0, caustic_radius = 0;  ///< largest of a lookup, scene units, above 0
    double caustic_reach = 0;               ///< how far caustic lookups go where photons are few, scene units, above 0
    double stored_per_emitted = 0;          ///< of the pilot's photons
    double caustic_share = 0;               ///< of the emitted flux that makes caustics, of the pilot
    double specular_share = 0;              ///< of the photons that meet mirror, glass or gloss first
    Aim aim;                                ///< for the caustic pass; no cells: emit evenly
    std::vector<Derived> derived;           ///< in the order they were found
};

/// Flies a pilot of 4096 photons, looks where the eye looks (null: takes the whole scene as the picture) and derives
/// what `options` leaves open. Throws Error(limit) where a count that was asked for does not fit into memory, with the
/// estimate; counts of its own it bounds.
[[nodiscard]] Plan make_plan(const World& world, const Eye* eye, const PhotonOptions& options, std::uint32_t seed,
                             Progress& progress);

}  // namespace cardioid::photon

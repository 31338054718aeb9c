#pragma once
#include "photon/cache/overture.hpp"
#include "photon/hemisphere/hemisphere.hpp"
#include "photon/heuristics/plan.hpp"
#include "rt_core/api/eye.hpp"

namespace cardioid::photon {

/// How finely indirect light is gathered and kept, from the accuracy that is wanted.
struct Tuning {
    Hemisphere hemisphere;
    CacheRules indirect_rules, caustic_rules;
    OvertureRule overture;
    std::uint64_t radiance_photons = 0;  ///< about as many places where irradiance is known beforehand
    std::uint32_t light_rays = 0;        ///< that look for lamps at each of them
    std::vector<Derived> derived;        ///< what nobody gave, for -v
};

/// `eye` null: there is no picture.
[[nodiscard]] Tuning tune(const PhotonOptions& options, const Eye* eye, std::uint32_t seed);

}  // namespace cardioid::photon

#pragma once
#include "photon/gather/final_gather.hpp"
#include "rt_core/api/progress.hpp"

namespace cardioid::photon {

/// The report's irradiance cache: a final gather at each of the photons, whose positions are relative to `origin`
/// (ARL-TR-3608, section 5 and note [6]). In their order, without those whose surface rounding has lost. Stops early
/// when interrupted.
[[nodiscard]] std::vector<RadiancePhoton> precompute_irradiance(const World& world, const std::vector<Photon>& places,
                                                                Vec3d origin, const FinalGather& gather,
                                                                Progress& progress);

}  // namespace cardioid::photon

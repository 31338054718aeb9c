#pragma once
#include <vector>

#include "bench/goals.hpp"

namespace cardioid::bench {

/// Photons emitted, followed and stored, in the Cornell box as triangles and as CSG; items are stored photons, of one
/// thread.
void register_photon_emission_benchmarks();
std::vector<Goal> photon_emission_goals();

}  // namespace cardioid::bench

#pragma once
#include <vector>

#include "bench/goals.hpp"

namespace cardioid::bench {

/// Photon maps over the walls of a box, beside nanoflann (where it is installed) and the left-balanced heap of the
/// books: building, k = 50, k = 1, a fixed radius, queries in random and in Morton order, growth from 10^4 to 10^7
/// photons.
void register_photon_map_benchmarks();
std::vector<Goal> photon_map_goals();
std::vector<Bound> photon_map_bounds();

}  // namespace cardioid::bench

#pragma once
#include <vector>

#include "bench/goals.hpp"

namespace cardioid::bench {

/// Whole pictures of the Cornell boxes by `path`, counted in camera samples.
void register_path_benchmarks();
/// Against Embree alone on a box of triangles after a diffuse bounce.
std::vector<Goal> path_goals();

}  // namespace cardioid::bench

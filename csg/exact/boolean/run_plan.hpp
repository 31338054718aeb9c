#pragma once
#include <span>

#include "csg/exact/boolean/boolean_plan.hpp"
#include "rt_core/api/progress.hpp"

namespace cardioid::csg {

/// Does the steps of a plan, whose leaves are the meshes at their places, and rounds the last to doubles. Steps of one
/// height run in parallel. `progress` may be null; it gets the phase "evaluate", a share for each step by the leaves
/// below it. Throws Error(interrupted) when it says so, and Error(bad_input) of the first step in order that fails.
TriangleMesh run_plan(std::span<const PlannedBoolean> plan, std::span<const TriangleMesh> leaves, Progress* progress);

}  // namespace cardioid::csg

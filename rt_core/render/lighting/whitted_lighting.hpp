#pragma once
#include "rt_core/api/lighting.hpp"

namespace cardioid {

/// `--lighting whitted`: as `direct`, but where light may both be reflected and go on, both ways are followed instead
/// of one that is drawn (Whitted 1980), and lamps that stand for a grid of points are asked for each of them. A scene
/// of point lights, matt surfaces, mirrors and glass then has no noise at all, which is what comparing needs.
extern const LightingKind whitted_lighting;

}  // namespace cardioid

#pragma once
#include "rt_core/scene/scene.hpp"

namespace cardioid::bench {

/// The canonical Cornell box with its two blocks, or with a ball of mirror and one of glass in their stead: measured
/// geometry (Cornell University Program of Computer Graphics 1998), plain RGB reflectances, its camera.
Scene cornell_blocks();
Scene cornell_balls();

}  // namespace cardioid::bench

#pragma once
#include "rt_core/api/lighting.hpp"

namespace cardioid::photon {

/// `photon`: global illumination and caustics by photon mapping (ARL-TR-3608).
extern const LightingKind photon_lighting;

}  // namespace cardioid::photon

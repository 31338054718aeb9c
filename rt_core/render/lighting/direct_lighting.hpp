#pragma once
#include "rt_core/api/lighting.hpp"

namespace cardioid {

/// `direct`: light straight from its sources, seen directly, in mirrors and through glass, and what glossy surfaces
/// reflect of it. No light between diffuse surfaces, no caustics, and no ambient term in their stead.
extern const LightingKind direct_lighting;

}  // namespace cardioid

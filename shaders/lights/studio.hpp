#pragma once
#include <algorithm>

#include "rt_core/api/math.hpp"

namespace cardioid::shaders {

/// The built-in studio: a neutral dome, brightest overhead, dim at the horizon and below. Functions of z, the height of
/// a unit direction. White paper that faces up reflects 0.44, upright paper 0.28.
namespace studio {

constexpr float horizon = 0.28F, overhead = 0.60F, ground = 0.10F;

/// Radiance of the light it gives.
constexpr float radiance(float z) {
    return z > 0 ? horizon + (overhead - horizon) * z * z : horizon + (horizon - ground) * std::max(z, -1.0F);
}

/// What the camera sees behind the model: nearly white, a little darker below.
constexpr float backdrop(float z) {
    constexpr float low = 0.72F, high = 0.98F, low_z = -0.8F, high_z = 0.0F;
    const float s = std::clamp((z - low_z) / (high_z - low_z), 0.0F, 1.0F);
    return low + (high - low) * s * s * (3 - 2 * s);
}

}  // namespace studio

}  // namespace cardioid::shaders

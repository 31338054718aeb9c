#pragma once
#include "rt_core/api/bsdf.hpp"

namespace cardioid::shaders {

/// Whether a lobe, with all its flags, is among those asked for.
constexpr bool within(Lobe lobe, Lobe which) { return (lobe & which) == lobe; }

constexpr Vec3 flip_z(Vec3 v) { return {v.x, v.y, -v.z}; }

/// What chooses among lobes: the mean over the channels.
constexpr float average(Rgb c) { return (c.r + c.g + c.b) * (1.0F / 3); }

/// How likely each of two lobes is drawn: in proportion to their albedos, 0 for one that is not asked for.
struct LobeChoice {
    float first = 0, second = 0;
    LobeChoice(float albedo_first, float albedo_second) {
        const float sum = albedo_first + albedo_second;
        if (!(sum > 0)) return;
        first = albedo_first / sum;
        second = albedo_second > 0 ? 1 - first : 0;
    }
    [[nodiscard]] bool none() const { return first <= 0 && second <= 0; }
};

}  // namespace cardioid::shaders

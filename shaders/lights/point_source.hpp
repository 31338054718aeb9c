#pragma once
#include <cmath>

#include "rt_core/api/light.hpp"

namespace cardioid::shaders {

/// Intensity [W/sr] of a source that is a point: `intensity` (1), or `power` [W] over the solid angle that a source
/// of intensity 1 has as its power.
inline Rgb read_intensity(const Params& params, double power_of_unit_intensity) {
    if (!params.has("power")) return params.colour("intensity", Rgb(1));
    if (params.has("intensity")) params.wrong("power", "left out where intensity is given");
    return params.colour("power", {}) * static_cast<float>(1 / power_of_unit_intensity);
}

/// Light of the given intensity towards p from a point: intensity/d^2. Black at the point itself.
inline LightSample sample_point(Vec3d source, Vec3d p, Rgb intensity) noexcept {
    const Vec3d to_light = source - p;
    const double distance = length(to_light);
    if (!(distance > 0)) return {};
    const Rgb L = intensity * static_cast<float>(1 / (distance * distance));
    if (!is_finite(L)) return {};
    return {Vec3(to_light / distance), distance, L, 1, true};
}

/// Throws Error(bad_input) where the place is not finite.
inline Vec3d point_place(const LightInputs& in) {
    if (!is_finite(in.to_world.t))
        throw Error(ErrorCode::bad_input, in.params.where() + ": the light must stand at a finite place");
    return in.to_world.t;
}

}  // namespace cardioid::shaders

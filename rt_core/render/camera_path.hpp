#pragma once
#include <optional>

#include "rt_core/render/committed_scene.hpp"

namespace cardioid {

/// A camera ray and what it takes to follow it.
struct CameraRay {
    Ray ray;
    const Medium* medium;  ///< at its origin
    double pixel, spread;  ///< width of a pixel at the origin, and its growth per unit of distance
};

/// The surface that a camera ray meets first.
struct FirstHit {
    double distance = 0;
    SurfacePoint point;
    Albedo albedo;
};

std::optional<FirstHit> first_hit(const CommittedScene& scene, const CameraRay& camera) noexcept;

/// All light that comes along a camera ray. Mirrors and glass are followed, one of their ways at a time, until Russian
/// roulette ends the path; what is met behind them counts as LightParts::specular. Glossy lobes are not followed: their
/// reflection of the lights is direct light, that of everything else the module's.
LightParts light_along(const CommittedScene& scene, const LightingModule& module, const CameraRay& camera,
                       Sampler& sampler) noexcept;

}  // namespace cardioid

#pragma once
#include <functional>
#include <optional>

#include "rt_core/api/eye.hpp"
#include "rt_core/render/committed_scene.hpp"

namespace cardioid {

/// The surface that a camera ray meets first.
struct FirstHit {
    double distance = 0;
    SurfacePoint point;
    Albedo albedo;
};

std::optional<FirstHit> first_hit(const CommittedScene& scene, const EyeRay& camera) noexcept;

/// Follows a camera ray by mirrors and glass and calls `see` at each point that scatters light otherwise (Eye::look).
void look_along(const CommittedScene& scene, const EyeRay& camera, Sampler& sampler,
                const std::function<void(const Eye::Sight&)>& see);

/// All light that comes along a camera ray. Mirrors and glass are followed, one of their ways at a time, until Russian
/// roulette ends the path; what is met behind them counts as LightParts::specular. Glossy lobes are not followed: their
/// reflection of the lights is direct light, that of everything else the module's.
LightParts light_along(const CommittedScene& scene, const LightingModule& module, const EyeRay& camera,
                       Sampler& sampler) noexcept;

}  // namespace cardioid

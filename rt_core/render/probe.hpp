#pragma once
#include <functional>
#include <span>

#include "rt_core/api/lighting.hpp"
#include "rt_core/render/committed_scene.hpp"

namespace cardioid {

/// What a probe measures: irradiance on a small plate at `p` whose lit side looks along `d`, or the radiance that
/// comes to `p` along the ray with direction `d`.
enum class Quantity { irradiance, radiance };

struct ProbePoint {
    Vec3d p;  ///< scene units
    Vec3d d;  ///< normal or direction of the ray, not zero, any length
};

struct ProbeSettings {
    Quantity what = Quantity::irradiance;
    double noise = 0.01;             ///< relative standard error of the luminance to reach; 0: take most_samples
    std::uint32_t most_samples = 0;  ///< a point; 0: as many as noise takes, at most 2^24
    std::uint32_t seed = 0;
};

struct Reading {
    Rgb value;           ///< W/unit^2, or W/(sr unit^2)
    Rgb standard_error;  ///< of each channel
    std::uint32_t samples = 0;
    std::uint32_t bad_samples = 0;  ///< NaN, infinite or negative: counted as black
};

/// Measures each point, in parallel, the same bits for any number of threads. A point that lies on a surface whose
/// normal is within 60 degrees of `d` is taken as a point of that surface; the plate itself reflects nothing and
/// casts no shadow. Returns early, with the points done so far measured, when interrupted.
std::vector<Reading> probe(const CommittedScene& scene, const LightingModule& lighting,
                           std::span<const ProbePoint> points, const ProbeSettings& settings, Progress& progress);

}  // namespace cardioid

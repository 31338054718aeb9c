#pragma once
#include <functional>
#include <span>

#include "rt_core/api/lighting.hpp"
#include "rt_core/render/committed_scene.hpp"

namespace cardioid {

/// What a probe measures: irradiance on a small plate at `p` whose lit side looks along `d`, or the radiance that
/// comes to `p` from where `d` points to.
enum class Quantity { irradiance, radiance };

struct ProbePoint {
    Vec3d p;  ///< scene units
    Vec3d d;  ///< normal or direction of the ray, not zero, any length
};

struct ProbeSettings {
    Quantity what = Quantity::irradiance;
    double noise = 0.01;             ///< relative standard error of the luminance to reach; 0: take most_samples
    std::uint32_t most_samples = 0;  ///< a point, at least 16; 0: as many as noise takes, at most 2^24
    std::uint32_t seed = 0;
    std::uint64_t first = 0;  ///< number of the first point among all, for those who bring them in parts
};

struct Reading {
    Rgb value;                      ///< W/unit^2, or W/(sr unit^2)
    Rgb standard_error;             ///< of each channel
    std::uint32_t samples = 0;      ///< 1: exact, nothing was drawn at random; 0: not measured, or buried
    std::uint32_t bad_samples = 0;  ///< NaN, infinite or negative: counted as black
    bool reached = true;            ///< the noise asked for
    bool buried = false;            ///< the plate is inside an opaque solid, so that no light arrives
};

/// Measures each point, in parallel, the same bits for any number of threads and whatever other points there are. A
/// plate that lies on a surface whose normal is within 60 degrees of `d` is a point of that surface; the plate itself
/// reflects nothing and casts no shadow.
///
/// Samples come in 64 independently scrambled sequences, and the standard error is that of their means. They grow by
/// half or double until `noise` is reached. A point whose samples are all alike (a dark one) takes 10/noise of them
/// before that is believed: light that one path in so many would find may be missed.
///
/// When interrupted it returns early: points keep what they have, those not begun have no samples.
std::vector<Reading> probe(const CommittedScene& scene, const LightingModule& lighting,
                           std::span<const ProbePoint> points, const ProbeSettings& settings, Progress& progress);

}  // namespace cardioid

#pragma once
#include "rt_core/math/sampling.hpp"

namespace cardioid {

/// Standard deviation and reach of the Gaussian filter, pixels.
inline constexpr float gaussian_sigma = 0.5F, gaussian_reach = 1.5F;

/// A place about a pixel's centre, in pixels, with the density of the Gaussian filter cut off at its reach. Drawing
/// places instead of weighting neighbours keeps every sample in one pixel (Ernst et al. 2006).
inline Vec2d sample_gaussian_filter(Vec2 u) {
    constexpr float two_variances = 2 * gaussian_sigma * gaussian_sigma;
    static const float inside = 1 - std::exp(-gaussian_reach * gaussian_reach / two_variances);
    const float r = std::sqrt(-two_variances * std::log(1 - u.x * inside));
    const float phi = 2 * pi * u.y;
    return Vec2d(Vec2{r * std::cos(phi), r * std::sin(phi)});
}

/// The same of the box filter: anywhere in the pixel alike.
inline Vec2d sample_box_filter(Vec2 u) { return {double{u.x} - 0.5, double{u.y} - 0.5}; }

}  // namespace cardioid

#pragma once
#include <numbers>

#include "rt_core/math/sampling.hpp"

namespace cardioid {

/// Standard deviation and reach of the Gaussian filter, pixels.
inline constexpr double gaussian_sigma = 0.5, gaussian_reach = 1.5;

/// A place about a pixel's centre, in pixels, with the density of the Gaussian filter cut off at its reach. Drawing
/// places instead of weighting neighbours keeps every sample in one pixel (Ernst et al. 2006).
inline Vec2d sample_gaussian_filter(Vec2 u) {
    constexpr double two_variances = 2 * gaussian_sigma * gaussian_sigma;
    const double inside = 1 - std::exp(-gaussian_reach * gaussian_reach / two_variances);
    const double r = std::sqrt(-two_variances * std::log1p(-static_cast<double>(u.x) * inside));
    const double phi = 2 * std::numbers::pi * u.y;
    return {r * std::cos(phi), r * std::sin(phi)};
}

/// The same of the box filter: anywhere in the pixel alike.
inline Vec2d sample_box_filter(Vec2 u) { return {u.x - 0.5, u.y - 0.5}; }

}  // namespace cardioid

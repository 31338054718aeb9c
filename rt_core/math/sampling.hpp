#pragma once
#include <cmath>
#include <numbers>

#include "rt_core/math/vec.hpp"

namespace cardioid {

inline constexpr float pi = std::numbers::pi_v<float>;
inline constexpr float inv_pi = std::numbers::inv_pi_v<float>;

/// The unit disc, uniformly, by the area-preserving concentric map (Shirley, Chiu 1997).
inline Vec2 sample_disc(Vec2 u) {
    const Vec2 c{2 * u.x - 1, 2 * u.y - 1};
    if (c.x == 0 && c.y == 0) return {0, 0};
    const bool wide = std::abs(c.x) > std::abs(c.y);
    const float r = wide ? c.x : c.y;
    const float phi = wide ? pi / 4 * (c.y / c.x) : pi / 2 - pi / 4 * (c.x / c.y);
    return {r * std::cos(phi), r * std::sin(phi)};
}

/// A direction about +z with pdf cos(theta)/pi [1/sr].
inline Vec3 sample_cosine_hemisphere(Vec2 u) {
    const Vec2 d = sample_disc(u);
    return {d.x, d.y, std::sqrt(std::max(0.0F, 1 - d.x * d.x - d.y * d.y))};
}

/// A direction of the whole sphere with pdf 1/(4 pi).
inline Vec3 sample_sphere(Vec2 u) {
    const float z = 1 - 2 * u.x;
    const float r = std::sqrt(std::max(0.0F, 1 - z * z));
    return {r * std::cos(2 * pi * u.y), r * std::sin(2 * pi * u.y), z};
}

/// A direction within the cone about +z whose half angle a has 1 - cos(a) = `one_minus_cos`,
/// with pdf 1/(2 pi one_minus_cos). Taking 1 - cos keeps narrow cones (the sun) exact.
inline Vec3 sample_cone(Vec2 u, float one_minus_cos) {
    const float drop = u.x * one_minus_cos;
    const float r = std::sqrt(std::max(0.0F, drop * (2 - drop)));
    return {r * std::cos(2 * pi * u.y), r * std::sin(2 * pi * u.y), 1 - drop};
}

/// Weight of a strategy with density `pdf` against one other (Veach 1997, eq. 9.13, beta = 2).
inline float power_heuristic(float pdf, float other) {
    const float a = pdf * pdf, b = other * other;
    return a + b > 0 ? a / (a + b) : 0;
}

}  // namespace cardioid

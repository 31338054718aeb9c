#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "rt_core/math/vec.hpp"

namespace cardioid {

inline constexpr float pi = std::numbers::pi_v<float>;
inline constexpr float inv_pi = std::numbers::inv_pi_v<float>;

/// Sine and cosine of an angle in [-pi/4, pi/4], by their series; within 1e-7.
inline Vec2 sin_cos_of_eighth(float a) {
    const float b = a * a;
    const float sine = a * (1 - b * (1.0F / 6 - b * (1.0F / 120 - b * (1.0F / 5040 - b * (1.0F / 362880)))));
    const float cosine = 1 - b * (0.5F - b * (1.0F / 24 - b * (1.0F / 720 - b * (1.0F / 40320))));
    return {sine, cosine};
}

/// The unit disc, uniformly, by the area-preserving concentric map (Shirley, Chiu 1997).
inline Vec2 sample_disc(Vec2 u) {
    const Vec2 c{2 * u.x - 1, 2 * u.y - 1};
    if (c.x == 0 && c.y == 0) return {0, 0};
    // Swaps by bits, because a branch that goes either way for every other pair of numbers costs more than all of this.
    const std::uint32_t wide = std::abs(c.x) > std::abs(c.y) ? ~0U : 0U;
    const auto either = [wide](float yes, float no) {
        return std::bit_cast<float>((std::bit_cast<std::uint32_t>(yes) & wide) |
                                    (std::bit_cast<std::uint32_t>(no) & ~wide));
    };
    const float r = either(c.x, c.y);
    const Vec2 angle = sin_cos_of_eighth(pi / 4 * (either(c.y, c.x) / r));
    return {r * either(angle.y, angle.x), r * either(angle.x, angle.y)};
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

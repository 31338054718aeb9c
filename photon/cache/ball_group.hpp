#pragma once
#include <cstdint>

#include "rt_core/api/math.hpp"

namespace cardioid::photon {

/// Eight balls on surfaces, a column half a cache line.
struct alignas(32) BallGroup {
    static constexpr int lanes = 8;
    float x[lanes], y[lanes], z[lanes];     ///< middle; a place that nothing is near where there is no ball
    float nx[lanes], ny[lanes], nz[lanes];  ///< unit normal
    float per_radius[lanes];                ///< 1 / radius
    std::uint32_t index[lanes];
};

/// A place on a surface that is looked for in balls.
struct BallQuery {
    Vec3 p, n;
    float per_turn;  ///< 1 / the largest sqrt(1 - n.n_i)
};

/// Height over its plane that a ball is of use for, as a share of its radius.
inline constexpr float ball_flatness = 0.1F;

/// Equation 6 of ARL-TR-3608 as a share of what is allowed, for each ball: |p - p_i| / radius_i + sqrt(1 - n.n_i) /
/// turn. Returns the lanes, as bits, of those that the place is within: below 1, and not off their plane.
using ScanBalls = unsigned (*)(const BallGroup& group, const BallQuery& query, float* t) noexcept;

/// All kinds give the same bits: same operations in the same order.
unsigned scan_balls_plain(const BallGroup& group, const BallQuery& query, float* t) noexcept;
#if defined(__x86_64__)
unsigned scan_balls_avx2(const BallGroup& group, const BallQuery& query, float* t) noexcept;
#endif
/// The quickest that this processor can run.
[[nodiscard]] ScanBalls quickest_scan_balls() noexcept;

}  // namespace cardioid::photon

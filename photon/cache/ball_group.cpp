#include "photon/cache/ball_group.hpp"

#include <algorithm>
#include <cmath>

namespace cardioid::photon {

unsigned scan_balls_plain(const BallGroup& g, const BallQuery& q, float* t) noexcept {
    unsigned within = 0;
    for (int i = 0; i < BallGroup::lanes; ++i) {
        const float x = q.p.x - g.x[i], y = q.p.y - g.y[i], z = q.p.z - g.z[i];
        const float cosine = q.n.x * g.nx[i] + q.n.y * g.ny[i] + q.n.z * g.nz[i];
        const float distance = std::sqrt(x * x + y * y + z * z) * g.per_radius[i];
        t[i] = distance + std::sqrt(std::max(0.0F, 1 - cosine)) * q.per_turn;
        const float height = x * (q.n.x + g.nx[i]) + y * (q.n.y + g.ny[i]) + z * (q.n.z + g.nz[i]);
        const float off = std::abs(height) * g.per_radius[i];
        within |= static_cast<unsigned>((t[i] < 1) & (off < 2 * ball_flatness)) << i;
    }
    return within;
}

ScanBalls quickest_scan_balls() noexcept {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) return scan_balls_avx2;
#endif
    return scan_balls_plain;
}

}  // namespace cardioid::photon

#include "photon/cache/occluders.hpp"

#include <algorithm>
#include <cmath>

namespace cardioid::photon {

namespace {

/// The foot of a wall still belongs to its near side, whatever rounding does.
constexpr float foot = 1 + 1e-3F;
/// Neighbouring corners are of one wall where their distances differ by less than this factor.
constexpr float same_wall = 3;

}  // namespace

Occluders::Occluders(const Hemisphere& hemisphere, std::span<const HemisphereRay> rays, float reach) {
    const auto lowest = rays.last(static_cast<std::size_t>(hemisphere.sectors));
    for (const HemisphereRay& ray : lowest) nearest_ = std::min(nearest_, ray.distance * std::hypot(ray.d.x, ray.d.y));
    if (!(nearest_ < reach)) {
        nearest_ = std::numeric_limits<float>::infinity();
        return;
    }
    // Between two corners a wall may come nearer than both, by half the square of their angle.
    const float turn = 2 * pi / static_cast<float>(hemisphere.sectors);
    nearest_ *= 1 - turn * turn / 2;
    corners_.reserve(lowest.size());
    for (const HemisphereRay& ray : lowest) {
        const float distance = std::min(ray.distance, 4 * reach / std::hypot(ray.d.x, ray.d.y));
        corners_.push_back({ray.d.x * distance, ray.d.y * distance});
    }
}

bool Occluders::inside(Vec3 v) const noexcept {
    const Vec2 q{v.x, v.y};
    const auto n = corners_.size();
    const float turn = std::atan2(q.y, q.x) * (0.5F * inv_pi);
    const auto sector = static_cast<std::size_t>((turn < 0 ? turn + 1 : turn) * static_cast<float>(n)) % n;
    // The sector's own corner lies before or behind q.
    const bool behind = cross(corners_[sector], q) < 0;
    const Vec2 a = corners_[behind ? (sector + n - 1) % n : sector];
    const Vec2 b = corners_[behind ? sector : (sector + 1) % n];
    const float a2 = dot(a, a), b2 = dot(b, b);
    if (std::max(a2, b2) > same_wall * same_wall * std::min(a2, b2)) return dot(q, q) <= std::min(a2, b2) * foot;
    const Vec2 wall = b - a;
    return cross(wall, q - a) >= (1 - foot) * cross(wall, Vec2{} - a);
}

}  // namespace cardioid::photon

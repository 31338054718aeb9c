#pragma once
#include "rt_core/api/surface.hpp"

namespace cardioid::photon {

/// Geometric normal on the side that the world direction w is on.
inline Vec3 geometric_normal(const SurfacePoint& point, Vec3 w) noexcept {
    return dot(point.ng, w) < 0 ? -point.ng : point.ng;
}
/// Shading normal on that side.
inline Vec3 shading_normal(const SurfacePoint& point, Vec3 w) noexcept {
    return dot(point.ng, w) < 0 ? -point.frame.n : point.frame.n;
}
/// What light along w, away from the point, travels in.
inline const Medium* medium_towards(const SurfacePoint& point, Vec3 w) noexcept {
    return dot(point.ng, w) < 0 ? point.back : point.front;
}

}  // namespace cardioid::photon

#pragma once
#include <cmath>

#include "rt_core/math/vec.hpp"

namespace cardioid {

/// A right-handed orthonormal frame around n (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
struct Frame {
    Vec3 s, t, n;
    Frame() : s(1, 0, 0), t(0, 1, 0), n(0, 0, 1) {}
    /// n must have unit length.
    explicit Frame(Vec3 normal) : n(normal) {
        const float sign = std::copysign(1.0F, n.z);
        const float a = -1.0F / (sign + n.z);
        const float b = n.x * n.y * a;
        s = {1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x};
        t = {b, sign + n.y * n.y * a, -n.y};
    }
    [[nodiscard]] Vec3 to_local(Vec3 v) const { return {dot(v, s), dot(v, t), dot(v, n)}; }
    [[nodiscard]] Vec3 to_world(Vec3 v) const { return s * v.x + t * v.y + n * v.z; }
};

}  // namespace cardioid

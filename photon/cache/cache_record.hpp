#pragma once
#include "photon/cache/occluders.hpp"
#include "photon/hemisphere/hemisphere.hpp"

namespace cardioid::photon {

/// Irradiance at a point and all that is needed to guess it nearby: what equation 5 of ARL-TR-3608 averages.
struct CacheRecord {
    Vec3 p;  ///< relative to the origin of its cache, scene units
    Vec3 n;  ///< unit, on the side that is lit; Frame(n) is that of the hemisphere
    Rgb E;   ///< W/unit^2
    Gradient rotational, translational;
    float distance = 0;  ///< R: harmonic mean distance of what it sees, later clamped by its neighbours, scene units
    float least = 0, most = 0;  ///< limits of its reach, from the size of pixels, scene units
    Occluders occluders;

    /// Irradiance at p + step on a surface with normal `normal`, to first order (Ward, Heckbert 1992, eq. 5); >= 0.
    [[nodiscard]] Rgb guess(Vec3 step, Vec3 normal) const noexcept {
        const Rgb sum = E + rotational.along(cross(n, normal)) + translational.along(step);
        return {std::max(sum.r, 0.0F), std::max(sum.g, 0.0F), std::max(sum.b, 0.0F)};
    }
};

}  // namespace cardioid::photon

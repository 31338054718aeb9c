#pragma once
#include <functional>
#include <span>

#include "photon/cache/irradiance_cache.hpp"
#include "rt_core/api/eye.hpp"
#include "rt_core/api/progress.hpp"

namespace cardioid::photon {

/// How an irradiance cache is filled for a picture.
struct OvertureRule {
    std::uint32_t seed = 0;
    int rounds = 2;  ///< how often every pixel is looked through once more, elsewhere each time
};

/// A cache to fill, and what makes its point at a place on the side of n. The number is the point's own.
struct CacheFill {
    IrradianceCache& cache;
    std::function<CacheRecord(const SurfacePoint&, Vec3 n, std::uint64_t number)> make;
};

/// Fills caches with what the eye needs: every 64th pixel is looked through first, then those between, and so on
/// (Ward's overture). All pixels of a step ask the same frozen caches, and what they lack is added when all are done,
/// in the order of the pixels, so that a cache is the same for any number of threads. Stops early when interrupted.
void play_overture(const Eye& eye, std::span<const CacheFill> fills, const OvertureRule& rule, Progress& progress);

}  // namespace cardioid::photon

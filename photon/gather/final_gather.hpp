#pragma once
#include "photon/cache/cache_record.hpp"
#include "photon/gather/incoming_light.hpp"

namespace cardioid::photon {

/// Gathers indirect light over hemispheres (ARL-TR-3608, section 5 and note [7]).
class FinalGather {
public:
    /// World and light must outlive it.
    FinalGather(const World& world, const IncomingLight& light, const Hemisphere& hemisphere, std::uint32_t seed)
        : world_(world), light_(light), hemisphere_(hemisphere), seed_(seed) {}

    /// A cache point at `point` on the side of the shading normal n; `index` names its random numbers. Its position,
    /// relative to `origin`, its irradiance as the diffuse lobe there takes it, and all but the limits of its reach are
    /// set.
    [[nodiscard]] CacheRecord record(const SurfacePoint& point, Vec3 n, std::uint64_t index, Vec3d origin) const;

private:
    const World& world_;
    const IncomingLight& light_;
    Hemisphere hemisphere_;
    std::uint32_t seed_;
};

}  // namespace cardioid::photon

#include "photon/lighting/eye_caches.hpp"

#include "photon/gather/final_gather.hpp"

namespace cardioid::photon {

namespace {

/// Light of the caustic map; it is known where it is asked for and changes over the size of its disc.
CacheRecord caustic_record(const World& world, const LightMaps& maps, const SurfacePoint& point, Vec3 n, Vec3d origin) {
    const Vec3 ng = dot(point.ng, n) < 0 ? -point.ng : point.ng;
    BsdfMemory memory;
    const Estimate light = maps.caustics->irradiance(point, ng, maps.caustic_lookup, &world, world.bsdf(point, memory));
    CacheRecord record;
    record.p = Vec3(point.p - origin);
    record.n = n;
    record.E = light.E;
    record.distance = light.radius;
    return record;
}

}  // namespace

EyeCaches fill_eye_caches(const World& world, const Eye& eye, const PhotonOptions& options, const LightMaps& maps,
                          const IncomingLight& incoming, const Tuning& tuning, std::uint32_t seed, Progress& progress) {
    EyeCaches caches;
    if (world.bounds().empty()) return caches;
    std::vector<CacheFill> fills;
    const FinalGather gather(world, incoming, tuning.hemisphere, seed);
    const Vec3d origin = world.bounds().centre();
    if (options.indirect == Indirect::cache && maps.radiance.size() > 0) {
        caches.indirect.emplace(tuning.indirect_rules, world.bounds());
        fills.push_back({*caches.indirect, [&](const SurfacePoint& point, Vec3 n, std::uint64_t number) {
                             return gather.record(point, n, number, origin);
                         }});
    }
    if (maps.caustics) {
        caches.caustic.emplace(tuning.caustic_rules, world.bounds());
        fills.push_back({*caches.caustic, [&](const SurfacePoint& point, Vec3 n, std::uint64_t) {
                             return caustic_record(world, maps, point, n, origin);
                         }});
    }
    if (fills.empty()) return caches;
    progress.begin("cache");
    play_overture(eye, fills, tuning.overture, progress);
    return caches;
}

}  // namespace cardioid::photon

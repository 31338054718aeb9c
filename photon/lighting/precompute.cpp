#include "photon/lighting/precompute.hpp"

#include <atomic>

#include "photon/gather/photon_surface.hpp"
#include "photon/gather/side.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::photon {

std::vector<RadiancePhoton> precompute_irradiance(const World& world, const std::vector<Photon>& places, Vec3d origin,
                                                  const FinalGather& gather, Progress& progress) {
    std::vector<RadiancePhoton> all(places.size());
    std::vector<char> found(places.size());
    std::atomic<std::size_t> done{0};
    parallel_for(static_cast<std::int64_t>(places.size()), [&](std::int64_t p) {
        if (progress.interrupted()) return;
        const auto i = static_cast<std::size_t>(p);
        const Photon& photon = places[i];
        if (const auto point = surface_under(world, photon, origin)) {
            const Vec3 n = shading_normal(*point, decode_direction(photon.wi));
            const CacheRecord record = gather.record(*point, n, i, origin);
            all[i] = {photon.p, photon.n, photon.region, record.E, record.distance, record.distance};
            found[i] = is_finite(record.E);
        }
        progress.update(static_cast<double>(++done) / static_cast<double>(places.size()));
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (found[i]) all[kept++] = all[i];
    all.resize(kept);
    return all;
}

}  // namespace cardioid::photon

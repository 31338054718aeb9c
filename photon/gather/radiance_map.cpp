#include "photon/gather/radiance_map.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "photon/gather/lambert.hpp"
#include "photon/gather/photon_surface.hpp"
#include "photon/gather/side.hpp"
#include "photon/map/edges.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::photon {

namespace {

/// Photons that one thread turns into radiance photons at a time.
constexpr std::size_t chunk_size = 256;
/// Normals of a place and of the point that asks may differ by 30 degrees; the report has 60.
constexpr float least_cos = 0.866F, report_least_cos = 0.5F;
/// How far off the plane a place may be, for a unit of distance within it.
constexpr float steepness = 0.25F;
/// A place reaches to so many others around it, of which one is then nearer all but e^-8 of the time.
constexpr std::uint32_t others = 8;
/// Photons that a lookup has to expect, for a standard error of 25 %.
constexpr float fewest_photons = 16;

Rgb direct_irradiance(const World& world, const SurfacePoint& point, Vec3 ng, const RadianceRule& rule,
                      std::uint64_t index) {
    const Lambert white(Rgb{pi});
    Rgb sum;
    for (std::uint32_t i = 0; i < rule.light_rays; ++i) {
        Sampler sampler(rule.seed, Purpose::gather, index, i);
        sum += world.direct(point, white, ng, sampler);
    }
    return sum * (1 / static_cast<float>(rule.light_rays));
}

/// Gives each place its reach, and leaves out those whose neighbours are too far apart. Where the places are, and not
/// how many photons of the map a lookup found, tells both: else lookups that found more by chance would be kept.
void set_reach(std::vector<RadiancePhoton>& all, const RadianceRule& rule) {
    const PointTree<RadiancePhoton> tree(all);
    const float widest = rule.lookup.max_radius * std::sqrt(others / (fewest_photons * rule.share));
    parallel_for(static_cast<std::int64_t>(all.size()), [&](std::int64_t i) {
        RadiancePhoton& place = all[static_cast<std::size_t>(i)];
        thread_local Neighbours found;
        tree.nearest({.p = place.p,
                      .max_radius = widest,
                      .n = decode_direction(place.n),
                      .least_cos = least_cos,
                      .steepness = steepness,
                      .region = place.region},
                     others + 1, found);
        if (found.size <= others) return;
        place.reach = std::min(std::sqrt(*std::max_element(found.d2, found.d2 + found.size)), rule.lookup.max_radius);
    });
    std::erase_if(all, [](const RadiancePhoton& place) { return !(place.reach > 0); });
}

}  // namespace

std::vector<RadiancePhoton> make_radiance_photons(const World& world, const Shot& places, const PhotonMap& map,
                                                  const RadianceRule& rule, Progress& progress) {
    const std::size_t count = (places.photons.size() + rule.every - 1) / rule.every;
    std::vector<std::vector<RadiancePhoton>> chunks((count + chunk_size - 1) / chunk_size);
    std::atomic<std::size_t> done{0};
    parallel_for(static_cast<std::int64_t>(chunks.size()), [&](std::int64_t c) {
        if (progress.interrupted()) return;
        const auto chunk = static_cast<std::size_t>(c);
        for (std::size_t i = chunk * chunk_size; i < std::min((chunk + 1) * chunk_size, count); ++i) {
            const Photon& photon = places.photons[i * rule.every];
            const auto point = surface_under(world, photon, places.origin);
            if (!point) continue;
            const Vec3 ng = geometric_normal(*point, decode_direction(photon.wi));
            const Estimate rest = map.irradiance(*point, ng, rule.lookup, &world);
            Rgb E = rest.E + direct_irradiance(world, *point, ng, rule, i);
            if (rule.caustics) E += rule.caustics->irradiance(*point, ng, rule.caustic_lookup, &world).E;
            if (is_finite(E)) chunks[chunk].push_back({photon.p, photon.n, photon.region, E, rest.radius, 0});
        }
        progress.update(static_cast<double>(++done) / static_cast<double>(chunks.size()));
    });
    std::vector<RadiancePhoton> all;
    all.reserve(count);
    for (const auto& chunk : chunks) all.insert(all.end(), chunk.begin(), chunk.end());
    set_reach(all, rule);
    return all;
}

const RadiancePayload* RadianceMap::nearest(const SurfacePoint& point, Vec3 ng) const noexcept {
    const Nearest found = tree_.nearest({.p = Vec3(point.p - origin_),
                                         .n = ng,
                                         .least_cos = least_cos,
                                         .steepness = steepness,
                                         .region = point.id.region});
    if (!found.found()) return nullptr;
    const RadiancePayload& known = tree_.payload(found.index);
    return found.d2 <= known.reach * known.reach ? &known : nullptr;
}

Rgb RadianceMap::mean(const SurfacePoint& point, Vec3 ng, std::uint32_t nearest, bool edges) const noexcept {
    const PointQuery query{.p = Vec3(point.p - origin_), .n = ng, .least_cos = report_least_cos};
    Neighbours found;
    tree_.nearest(query, nearest, found);
    if (found.size == 0) return {};
    Rgb sum;
    for (std::uint32_t i = 0; i < found.size; ++i) {
        const RadiancePayload& known = tree_.payload(found.index[i]);
        if (found.d2[i] <= known.reach * known.reach) sum += known.E;
    }
    const float share = edges ? accepted_share(tree_, query, found.d2[found.size - 1], found.size) : 1;
    return sum * (1 / (static_cast<float>(found.size) * share));
}

bool RadianceMap::near(Vec3d p, float radius) const noexcept {
    return tree_.nearest({.p = Vec3(p - origin_), .max_radius = radius}).found();
}

std::vector<RadiancePhoton> RadianceMap::photons() const {
    std::vector<RadiancePhoton> all(size());
    for (std::uint32_t i = 0; i < size(); ++i) {
        const RadiancePayload& known = tree_.payload(i);
        all[i] = {tree_.position(i), tree_.normal(i), tree_.region(i), known.E, known.blur, known.reach};
    }
    return all;
}

}  // namespace cardioid::photon

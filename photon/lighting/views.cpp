/// Debug pictures of what the module knows.
#include <algorithm>

#include "photon/gather/side.hpp"
#include "photon/lighting/photon_module.hpp"

namespace cardioid::photon {

namespace {

/// Half the width of a drawn point, pixels.
constexpr float dot_pixels = 1.25F;
/// How bright the grey is that points are drawn over.
constexpr float ground = 0.2F;

/// A colour of its own for everything that has a number.
Rgb colour_of(std::uint32_t number) {
    const std::uint64_t bits = mix64(number);
    const auto channel = [&](int shift) { return 0.25F + 0.75F * static_cast<float>(bits >> shift & 255U) / 255; };
    return {channel(0), channel(8), channel(16)};
}

Rgb photon_dots(const PhotonMap* map, const SurfacePoint& point, float dot_radius) {
    if (!map) return Rgb(ground);
    const Nearest found = map->tree().nearest({.p = Vec3(point.p - map->origin()), .max_radius = dot_radius});
    return found.found() ? map->flux(found.index) * (1 / map->flux_scale()) : Rgb(ground);
}

Rgb cache_points(const IrradianceCache& cache, const SurfacePoint& point, float dot_radius, bool as_reach) {
    Rgb colour(ground);
    float nearest = HUGE_VALF, reach = 0, weights = 0;
    cache.around(point.p, point.frame.n, [&](std::uint32_t i, Vec3 step, float t) {
        const CacheRecord& record = cache.records()[i];
        reach += cache.reach(record) * (1 - t), weights += 1 - t;
        if (length(step) >= nearest) return;
        nearest = length(step);
        colour = nearest < dot_radius ? Rgb(1) : colour_of(i) * 0.5F;
    });
    if (!as_reach) return colour;
    constexpr float white = 32;  // pixels
    const auto pixel = static_cast<float>(std::max(point.footprint, 1e-30));
    return Rgb(weights > 0 ? reach / weights / pixel / white : 0.0F);
}

}  // namespace

/// `photons`: those of the map as dots, as bright as their flux. `map`: what a lookup in it makes of them (figure 1).
/// `lookup`, `gather`: one of each (figures 2 and 5). `cache`: cache points as dots, around each its reach (figures 3
/// and 4). `irradiance`: indirect light without materials. `radius`: reach of cache points, white from 32 pixels on.
Rgb PhotonModule::view(const std::string& name, const World& world, const SurfacePoint& point) const noexcept {
    const auto dot_radius = static_cast<float>(dot_pixels * point.footprint);
    const PhotonMap* map = maps_.global ? &*maps_.global : maps_.caustics ? &*maps_.caustics : nullptr;
    if (name == "photons") return photon_dots(map, point, dot_radius);
    if (name == "map") return map ? density(world, *map, point) : Rgb{};
    if (name == "lookup") return shown_ ? shown_->lookup(map, point, dot_radius) : Rgb(ground);
    if (name == "gather") return shown_ ? shown_->gather(point, 2 * dot_radius) : Rgb(ground);
    if (name == "irradiance") {
        Sampler sampler(seed_, Purpose::gather, 0, 0);
        BsdfMemory memory;
        return incoming_ ? diffuse_irradiance(world, point, *world.bsdf(point, memory), point.ng, sampler) * inv_pi
                         : Rgb{};
    }
    if (caches_.indirect) return cache_points(*caches_.indirect, point, dot_radius, name == "radius");
    const RadianceMap& points = maps_.precomputed.size() > 0 ? maps_.precomputed : maps_.radiance;
    return points.near(point.p, dot_radius) ? Rgb(1) : Rgb(ground);
}

/// Radiance by the map alone, in the colours of the materials.
Rgb PhotonModule::density(const World& world, const PhotonMap& map, const SurfacePoint& point) const noexcept {
    BsdfMemory memory;
    const Bsdf& bsdf = *world.bsdf(point, memory);
    const LookupRule& rule = maps_.global ? maps_.global_lookup : maps_.caustic_lookup;
    return bsdf.albedo({0, 0, 1}).diffuse * map.irradiance(point, point.ng, rule, &world, &bsdf).E * inv_pi;
}

}  // namespace cardioid::photon

/// Debug pictures of what the module knows.
#include <algorithm>

#include "photon/gather/side.hpp"
#include "photon/lighting/photon_module.hpp"

namespace cardioid::photon {

namespace {

/// Half the width of a drawn point, pixels.
constexpr float dot_pixels = 1.5F;
/// How bright the grey is that points are drawn over.
constexpr float ground = 0.2F;

/// A colour of its own for everything that has a number.
Rgb colour_of(std::uint32_t number) {
    const std::uint64_t bits = mix64(number);
    const auto channel = [&](int shift) { return 0.25F + 0.75F * static_cast<float>(bits >> shift & 255U) / 255; };
    return {channel(0), channel(8), channel(16)};
}

}  // namespace

/// `photons`: those of the map as dots, as bright as their flux. `cache`: cache points as dots, around each its reach
/// (the report's figures 3 and 4). `irradiance`: indirect light without materials. `radius`: reach of cache points,
/// grey, of the picture's depth.
Rgb PhotonModule::view(const std::string& name, const World& world, const SurfacePoint& point) const noexcept {
    const Vec3 ng = point.ng;
    const auto dot_radius = static_cast<float>(dot_pixels * point.footprint);
    if (name == "photons") {
        const PhotonMap* map = maps_.global ? &*maps_.global : maps_.caustics ? &*maps_.caustics : nullptr;
        if (!map) return Rgb(ground);
        const Nearest found = map->tree().nearest({.p = Vec3(point.p - map->origin()), .max_radius = dot_radius});
        return found.found() ? map->flux(found.index) * (1 / map->flux_scale()) : Rgb(ground);
    }
    if (name == "irradiance") {
        Sampler sampler(seed_, Purpose::gather, 0, 0);
        return diffuse_irradiance(world, point, ng, sampler) * inv_pi;
    }
    if (!caches_.indirect) {
        const RadianceMap& points = maps_.precomputed.size() > 0 ? maps_.precomputed : maps_.radiance;
        return points.near(point.p, dot_radius) ? Rgb(1) : Rgb(ground);
    }
    const IrradianceCache& cache = *caches_.indirect;
    Rgb colour(ground);
    float nearest = HUGE_VALF, reach = 0, weights = 0;
    cache.around(point.p, point.frame.n, [&](std::uint32_t i, Vec3 step, float t) {
        const CacheRecord& record = cache.records()[i];
        reach += cache.reach(record) * (1 - t), weights += 1 - t;
        if (length(step) >= nearest) return;
        nearest = length(step);
        colour = nearest < dot_radius ? Rgb(1) : colour_of(i) * 0.5F;
    });
    if (name == "cache") return colour;
    return Rgb(weights > 0 ? reach / weights / static_cast<float>(std::max(point.footprint, 1e-30)) / 32 : 0.0F);
}

}  // namespace cardioid::photon

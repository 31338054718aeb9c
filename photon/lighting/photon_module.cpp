#include "photon/lighting/photon_module.hpp"

#include <fmt/format.h>

#include "photon/file/map_reader.hpp"
#include "photon/file/shape_text.hpp"
#include "photon/gather/side.hpp"
#include "photon/heuristics/counts.hpp"
#include "photon/lighting/phase_times.hpp"

namespace cardioid::photon {

namespace {

/// Rays of a gather where no cache point reaches: a place that only few samples of a pixel see.
constexpr int missed_rays = 32;

void tell(const std::vector<Derived>& derived, Progress& progress) {
    for (const Derived& d : derived) progress.log(1, fmt::format("photon.{} = {}: {}", d.name, d.value, d.why));
}

bool is_diffuse_alone(const Bsdf& bsdf) { return !any(bsdf.lobes() & Lobe::glossy); }

}  // namespace

void PhotonModule::prepare(const World& world, const Eye* eye, Progress& progress) {
    PhaseTimes times(progress);
    make_maps(world, eye, times);
    times_ = times.statistics();
}

void PhotonModule::make_maps(const World& world, const Eye* eye, Progress& progress) {
    scene_ = world.hash();
    progress.begin("plan");
    const Plan plan = make_plan(world, eye, options_, seed_, progress);
    const Tuning tuning = tune(options_, eye, seed_);
    if (!options_.memory)
        tell({{"memory", fmt::format("{:.0f}", default_memory() / 1e6), "half of RAM [MB]"}}, progress);
    tell(plan.derived, progress);
    tell(tuning.derived, progress);
    if (progress.interrupted()) return;
    maps_ = make_light_maps(world, eye, options_, plan, tuning, seed_, progress);
    if (!progress.interrupted()) look_up_from(world, eye, tuning, progress);
}

void PhotonModule::look_up_from(const World& world, const Eye* eye, const Tuning& tuning, Progress& progress) {
    incoming_.emplace(make_incoming(world, options_, maps_, eye == nullptr));
    glossy_caustics_.reset();
    if (maps_.caustics && options_.mode == Mode::physical)
        glossy_caustics_.emplace(world, *maps_.caustics, maps_.caustic_lookup, quick(maps_.caustic_lookup));
    if (!eye) return;
    caches_ = fill_eye_caches(world, *eye, options_, maps_, *incoming_, tuning, seed_, progress);
    shown_.emplace(world, *eye, options_, maps_, tuning.hemisphere, seed_);
}

/// Irradiance of indirect light on the side of wo.
Rgb PhotonModule::diffuse_irradiance(const World& world, const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo,
                                     Sampler& sampler) const noexcept {
    const Vec3 n = shading_normal(point, wo);
    if (caches_.indirect) {
        if (const auto E = caches_.indirect->irradiance(point.p, n)) return *E;
        missed_.fetch_add(1, std::memory_order_relaxed);
        return incoming_->irradiance(point, bsdf, n, missed_rays, sampler);
    }
    const Vec3 ng = geometric_normal(point, wo);
    if (maps_.precomputed.size() > 0)
        return maps_.precomputed.mean(point, ng, static_cast<std::uint32_t>(options_.cache_nearest),
                                      options_.cache_edge);
    if (options_.indirect == Indirect::map && maps_.global)
        return maps_.global->irradiance(point, ng, maps_.global_lookup, &world, &bsdf).E;
    return options_.indirect == Indirect::none ? Rgb{} : incoming_->irradiance(point, bsdf, n, 1, sampler);
}

Rgb PhotonModule::indirect(const World& world, const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo,
                           Sampler& sampler) const noexcept {
    if (!incoming_) return {};
    const Lobe lobes = bsdf.lobes();
    Rgb L;
    if (any(lobes & Lobe::diffuse)) {
        const Rgb albedo = bsdf.albedo(point.frame.to_local(wo)).diffuse;
        if (!is_black(albedo)) L += albedo * diffuse_irradiance(world, point, bsdf, wo, sampler) * inv_pi;
    }
    if (options_.indirect != Indirect::none && any(lobes & Lobe::glossy))
        L += incoming_->scattered(point, bsdf, wo, Lobe::glossy | Lobe::transmitted, sampler);
    return L;
}

Rgb PhotonModule::caustic(const World& world, const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo,
                          Sampler& sampler) const noexcept {
    if (!maps_.caustics) return {};
    if (glossy_caustics_ && !is_diffuse_alone(bsdf)) return glossy_caustics_->radiance(point, bsdf, wo, sampler);
    const Vec3 local = point.frame.to_local(wo);
    if (caches_.caustic && is_diffuse_alone(bsdf))
        if (const auto E = caches_.caustic->irradiance(point.p, shading_normal(point, wo)))
            return bsdf.albedo(local).diffuse * *E * inv_pi;
    return maps_.caustics->radiance(
        point, geometric_normal(point, wo), maps_.caustic_lookup,
        [&](Vec3 wi) { return bsdf.f(local, point.frame.to_local(wi)); }, &world);
}

std::vector<Statistic> PhotonModule::statistics() const {
    std::vector<Statistic> all = times_;
    all.insert(all.end(), maps_.statistics.begin(), maps_.statistics.end());
    const auto add = [&](const char* name, std::size_t value) {
        all.emplace_back(name, static_cast<std::int64_t>(value));
    };
    std::size_t bytes = maps_.radiance.memory_bytes() + maps_.precomputed.memory_bytes();
    if (maps_.global) bytes += maps_.global->memory_bytes();
    if (maps_.caustics) bytes += maps_.caustics->memory_bytes();
    add("photon bytes", bytes);
    if (caches_.indirect) {
        add("cache points", caches_.indirect->records().size());
        add("cache bytes", caches_.indirect->memory_bytes());
        add("cache misses", missed_.load());
    }
    if (caches_.caustic) {
        add("caustic cache points", caches_.caustic->records().size());
        add("caustic cache bytes", caches_.caustic->memory_bytes());
    }
    return all;
}

void PhotonModule::save(const std::string& path) const {
    MapWriter file(path, scene_);
    file.add_text("options", shape_text(options_, seed_));
    file.add("lookups", std::span<const LookupSizes>(&maps_.sizes, 1));
    if (maps_.global)
        file.add_photons("photons", maps_.global->photons(), maps_.global->origin(), maps_.global->flux_scale());
    if (maps_.caustics)
        file.add_photons("caustics", maps_.caustics->photons(), maps_.caustics->origin(), maps_.caustics->flux_scale());
    const auto add_places = [&](const std::string& name, const RadianceMap& map) {
        if (map.size() == 0) return;
        const std::vector<RadiancePhoton> places = map.photons();
        const Vec3d origin = map.origin();
        file.add(name, std::span<const RadiancePhoton>(places));
        file.add(name + " origin", std::span<const Vec3d>(&origin, 1));
    };
    add_places("radiance", maps_.radiance);
    add_places("cache", maps_.precomputed);
    file.finish();
}

void PhotonModule::load(const std::string& path, const World& world, const Eye* eye, Progress& progress) {
    PhaseTimes times(progress);
    load_maps(path, world, eye, times);
    times_ = times.statistics();
}

void PhotonModule::load_maps(const std::string& path, const World& world, const Eye* eye, Progress& progress) {
    progress.begin("load");
    const MapReader file(path);
    file.require_scene(world.hash());
    file.require_text("options", shape_text(options_, seed_));
    scene_ = world.hash();
    maps_ = {};
    const std::vector<LookupSizes> lookups = file.items<LookupSizes>("lookups");
    if (lookups.size() != 1) throw Error(ErrorCode::bad_input, path + ": section \"lookups\" is not one item");
    LookupSizes sizes = lookups[0];
    sizes.caustic_k = options_.caustic_k.value_or(sizes.caustic_k);
    if (options_.caustic_radius) sizes.caustic_radius = static_cast<float>(*options_.caustic_radius);
    set_lookups(options_, sizes, maps_);
    const auto read_map = [&](const std::string& name, std::optional<PhotonMap>& map) {
        if (!file.has(name)) return;
        const PhotonSet set = file.photons(name);
        map.emplace(set.photons, set.origin, set.flux_scale);
    };
    const auto read_places = [&](const std::string& name, RadianceMap& map) {
        if (file.has(name)) map = {file.items<RadiancePhoton>(name), file.items<Vec3d>(name + " origin").at(0)};
    };
    read_map("photons", maps_.global);
    read_map("caustics", maps_.caustics);
    if (maps_.caustics && maps_.caustic_lookup.spread) maps_.caustics->spread(maps_.caustic_lookup);
    read_places("radiance", maps_.radiance);
    read_places("cache", maps_.precomputed);
    const Tuning tuning = tune(options_, eye, seed_);
    tell(tuning.derived, progress);
    look_up_from(world, eye, tuning, progress);
}

std::vector<std::string> PhotonModule::views() const {
    return {"photons", "map", "lookup", "gather", "cache", "irradiance", "radius"};
}

}  // namespace cardioid::photon

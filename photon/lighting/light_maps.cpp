#include "photon/lighting/light_maps.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "photon/emission/shoot.hpp"
#include "photon/gather/gather_ends.hpp"
#include "photon/gather/radiance_photons.hpp"
#include "photon/lighting/precompute.hpp"

namespace cardioid::photon {

namespace {

LookupRule common_lookup(const PhotonOptions& options) {
    LookupRule rule;
    rule.fixed_radius = options.fixed_radius;
    rule.count_last = options.count_last;
    rule.edge = options.edge;
    rule.least_cos = std::cos(static_cast<float>(options.normal_tolerance) * pi / 180);
    return rule;
}

/// Fewer photons than that may all be absorbed, or miss a model that they do light, by chance.
constexpr std::uint64_t few_photons = 100;

class Maker {
public:
    Maker(const World& world, const Eye* eye, const PhotonOptions& options, const Plan& plan, const Tuning& tuning,
          std::uint32_t seed, Progress& progress)
        : world_(world), eye_(eye), options_(options), plan_(plan), tuning_(tuning), seed_(seed), progress_(progress) {}

    LightMaps make() {
        set_lookups(
            options_,
            {plan_.k, plan_.caustic_k, static_cast<float>(plan_.radius), static_cast<float>(plan_.caustic_reach)},
            maps_);
        if (plan_.caustic_count > 0) shoot_caustics();
        if (!progress_.interrupted()) shoot_global();
        return std::move(maps_);
    }

private:
    void shoot_global() {
        if (options_.indirect == Indirect::none && !options_.keep_map) return;
        progress_.begin("photons");
        Shot shot = shoot(world_, options_, {.seed = seed_, .count = plan_.count, .unwanted = unwanted()}, progress_);
        if (progress_.interrupted()) return;
        tell("photons", shot);
        if (shot.ledger.stored_photons() == 0) return warn_of_nothing(shot);
        if (shot.ledger.rays == shot.ledger.paths) warn_of_black();
        std::vector<Photon> places;
        if (options_.indirect == Indirect::precomputed)
            for (std::size_t i = 0; i < shot.photons.size(); i += static_cast<std::size_t>(options_.cache_every))
                places.push_back(shot.photons[i]);
        maps_.global.emplace(shot.photons, shot.origin, shot.flux_scale);
        shot.photons = {};
        if (gathers()) make_radiance(shot);
        if (options_.indirect == Indirect::precomputed && !progress_.interrupted()) precompute(places, shot.origin);
        if (options_.indirect != Indirect::map && !options_.keep_map) maps_.global.reset();
    }

    [[nodiscard]] bool gathers() const {
        return options_.indirect == Indirect::cache || options_.indirect == Indirect::gather;
    }
    /// Radiance photons look for lamps by rays, and for caustics in the map that has more of them.
    [[nodiscard]] PathClasses unwanted() const {
        if (gathers()) return only(PathClass::direct) | (maps_.caustics ? only(PathClass::caustic) : PathClasses{});
        if (options_.indirect == Indirect::map) return only(PathClass::direct) | only(PathClass::caustic);
        return {};
    }

    void make_radiance(const Shot& shot) {
        progress_.begin("radiance photons");
        const double stored = static_cast<double>(shot.ledger.stored_photons());
        const double wanted = static_cast<double>(tuning_.radiance_photons);
        const double count = std::min(wanted / stored, 1.0) * static_cast<double>(shot.emitted);
        Shot places =
            shoot(world_, options_, {.seed = ~seed_, .count = static_cast<std::uint64_t>(std::ceil(count))}, progress_);
        if (progress_.interrupted()) return;
        const RadianceRule rule{
            .seed = seed_,
            .share = static_cast<float>(static_cast<double>(places.emitted) / static_cast<double>(shot.emitted)),
            .light_rays = tuning_.light_rays,
            .lookup = maps_.global_lookup,
            .caustics = maps_.caustics ? &*maps_.caustics : nullptr,
            .caustic_lookup = quick(maps_.caustic_lookup),
            .broad_apart = options_.mode == Mode::physical};
        const RadiancePlaces at{radiance_places(places), std::move(places.photons), places.origin};
        maps_.radiance = {make_radiance_photons(world_, at, *maps_.global, rule, progress_), at.origin};
        maps_.statistics.emplace_back("radiance photons", static_cast<std::int64_t>(maps_.radiance.size()));
    }

    /// Where rays of gathers end, and at one in so many photons, for what rays meet that go on, and for other views.
    [[nodiscard]] std::vector<Photon> radiance_places(const Shot& shot) const {
        constexpr std::size_t one_in = 2;
        if (!eye_) return {shot.photons.begin(), shot.photons.end()};
        std::vector<Photon> places = gather_ends(world_, *eye_, seed_, tuning_.radiance_photons / 2, shot.origin);
        for (std::size_t i = 0; i < shot.photons.size(); i += one_in) places.push_back(shot.photons[i]);
        return places;
    }

    void precompute(const std::vector<Photon>& places, Vec3d origin) {
        progress_.begin("cache");
        const IncomingLight incoming(world_, {.map = &*maps_.global,
                                              .lookup = maps_.global_lookup,
                                              .caustics = maps_.caustics ? &*maps_.caustics : nullptr,
                                              .caustic_lookup = quick(maps_.caustic_lookup),
                                              .broad_apart = options_.mode == Mode::physical});
        const FinalGather gather(world_, incoming, tuning_.hemisphere, seed_);
        maps_.precomputed = {precompute_irradiance(world_, places, origin, gather, progress_), origin};
        maps_.statistics.emplace_back("cache points", static_cast<std::int64_t>(maps_.precomputed.size()));
    }

    void shoot_caustics() {
        progress_.begin("caustics");
        Shot shot = shoot(world_, options_,
                          {.seed = seed_,
                           .pass = Pass::caustic,
                           .keep = Keep::caustics,
                           .count = plan_.caustic_count,
                           .aim = plan_.aim.cells.empty() ? nullptr : &plan_.aim},
                          progress_);
        if (progress_.interrupted()) return;
        tell("caustic photons", shot);
        if (shot.photons.empty()) return;
        maps_.caustics.emplace(shot.photons, shot.origin, shot.flux_scale);
        if (maps_.caustic_lookup.spread) maps_.caustics->spread(maps_.caustic_lookup);
    }

    void tell(const std::string& what, const Shot& shot) {
        maps_.statistics.emplace_back(what + " emitted", static_cast<std::int64_t>(shot.emitted));
        maps_.statistics.emplace_back(what + " stored", static_cast<std::int64_t>(shot.ledger.stored_photons()));
        maps_.statistics.emplace_back(what + " lost share", shot.ledger.gap());
        const auto add_flux = [&](const char* name, const FluxSum& flux) {
            maps_.statistics.emplace_back(what + " W " + name, flux.r + flux.g + flux.b);
        };
        add_flux("emitted", shot.ledger.emitted);
        add_flux("absorbed", shot.ledger.absorbed);
        add_flux("escaped", shot.ledger.escaped);
        add_flux("cut off", shot.ledger.cut_off);
        if (shot.ledger.not_finite > 0)
            progress_.log(0, fmt::format("{} {} ended because a material gave no finite value: check its parameters",
                                         shot.ledger.not_finite, what));
    }

    void warn_of_nothing(const Shot& shot) {
        if (shot.emitted == 0 || world_.lights().empty())
            progress_.log(0, "no light sends photons: indirect light is black; add a light, or leave out --photons");
        else if (shot.emitted < few_photons)
            progress_.log(
                0, fmt::format("none of {} photon{} was kept: so few may miss everything; ask for more, or leave "
                               "their number out",
                               shot.emitted, shot.emitted == 1 ? "" : "s"));
        else if (shot.ledger.specular_first > 0)
            progress_.log(0,
                          fmt::format("none of {} photons met a surface that scatters light, only mirrors and glass: "
                                      "--photons adds nothing here; give something a material that is not all "
                                      "mirror",
                                      shot.emitted));
        else
            progress_.log(0, fmt::format("none of {} photons was kept: the lights do not shine on the model, or all of "
                                         "it is black; see that they face it",
                                         shot.emitted));
    }

    void warn_of_black() {
        progress_.log(0,
                      "no photon was scattered by what it met: all that the lights shine on is black, so there is no "
                      "indirect light; give materials a reflectance, or leave out --photons");
    }

    const World& world_;
    const Eye* eye_;
    const PhotonOptions& options_;
    const Plan& plan_;
    const Tuning& tuning_;
    std::uint32_t seed_;
    Progress& progress_;
    LightMaps maps_;
};

}  // namespace

LookupRule quick(LookupRule rule) {
    constexpr std::uint32_t enough = 20;
    rule.k = std::min(rule.k, enough);
    rule.spread = false;
    if (rule.edge != EdgeRule::report) rule.edge = EdgeRule::none;
    return rule;
}

void set_lookups(const PhotonOptions& options, const LookupSizes& sizes, LightMaps& maps) {
    maps.sizes = sizes;
    maps.global_lookup = maps.caustic_lookup = common_lookup(options);
    maps.global_lookup.k = sizes.k;
    maps.global_lookup.kernel = options.kernel;
    maps.global_lookup.max_radius = sizes.radius;
    maps.caustic_lookup.k = sizes.caustic_k;
    maps.caustic_lookup.kernel = options.caustic_kernel;
    maps.caustic_lookup.max_radius = sizes.caustic_radius;
    if (options.mode == Mode::report) return;
    // Where photons are few, a gather's far hits are content with a wider disc.
    const bool gathers = options.indirect == Indirect::cache || options.indirect == Indirect::gather;
    if (!options.radius && gathers) maps.global_lookup.max_radius *= 4;
    maps.caustic_lookup.spread = true;
    // The cone's weights scatter as those of a disc of two thirds as many photons.
    if (!options.caustic_k) maps.caustic_lookup.k = sizes.caustic_k * 3 / 2;
}

LightMaps make_light_maps(const World& world, const Eye* eye, const PhotonOptions& options, const Plan& plan,
                          const Tuning& tuning, std::uint32_t seed, Progress& progress) {
    return Maker(world, eye, options, plan, tuning, seed, progress).make();
}

IncomingLight make_incoming(const World& world, const PhotonOptions& options, const LightMaps& maps, bool always_near) {
    IncomingLight::Parts parts;
    parts.broad_apart = options.mode == Mode::physical;
    if (maps.radiance.size() > 0) parts.radiance = &maps.radiance;
    if (maps.global) parts.map = &*maps.global;
    if (maps.caustics) parts.caustics = &*maps.caustics;
    parts.lookup = maps.global_lookup;
    parts.caustic_lookup = quick(maps.caustic_lookup);
    parts.always_near = always_near;
    return {world, parts};
}

}  // namespace cardioid::photon

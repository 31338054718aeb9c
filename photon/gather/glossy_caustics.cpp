#include "photon/gather/glossy_caustics.hpp"

#include <algorithm>

#include "photon/gather/glossy_part.hpp"
#include "photon/gather/side.hpp"
#include "photon/propagation/breadth.hpp"
#include "photon/propagation/roulette.hpp"

namespace cardioid::photon {

namespace {

/// Surfaces that a ray may meet, those met before the roulette begins, and the best chance to live then.
constexpr int most_bounces = 10'000, sure_bounces = 4;
constexpr float best_chance = 0.95F;

constexpr Lobe glossy = GlossyPart::glossy, mirrors = Lobe::specular | Lobe::transmitted,
               followed_lobes = glossy | mirrors;

/// The same for the ray that is drawn and for the photon that comes the other way.
float density(const Bsdf& bsdf, Vec3 wo, Vec3 wi) noexcept { return bsdf.pdf(wo, wi, glossy); }

}  // namespace

/// A ray on its way back to the lamps.
struct GlossyCaustics::Walk {
    Ray ray;
    const Medium* medium = nullptr;
    Rgb throughput;
    Rgb sum;
    float pdf = 0;      ///< of the glossy lobe that it left last, towards where it went
    double length = 0;  ///< since then
    bool bent = false;  ///< by a mirror or glass since then
    FirstMirror last;   ///< the last of these; its distance counts from here
    int bounces = 0;
};

GlossyCaustics::GlossyCaustics(const World& world, const PhotonMap& map, const LookupRule& first,
                               const LookupRule& beyond)
    : world_(world), map_(map), first_(first), beyond_(beyond), least_breadth_(photon::least_breadth(world)) {}

Rgb GlossyCaustics::radiance(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Sampler& sampler) const noexcept {
    return looked_up(point, bsdf, wo, true) + followed(point, bsdf, wo, sampler);
}

/// What photons tell; beyond the first place by the glossy lobes alone.
Rgb GlossyCaustics::looked_up(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, bool first) const noexcept {
    const Vec3 n = geometric_normal(point, wo);
    Rgb L = looked_up(point, bsdf, wo, n, first);
    if (any(bsdf.lobes() & Lobe::transmitted)) L += looked_up(point, bsdf, wo, -n, first);
    return L;
}

/// The same of the photons on the side of n.
Rgb GlossyCaustics::looked_up(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Vec3 n, bool first) const noexcept {
    WeighedPhotons photons;
    map_.weigh(point, n, first ? first_ : beyond_, &world_, photons);
    const Vec3 out = point.frame.to_local(wo);
    const Rgb diffuse = any(bsdf.lobes() & Lobe::diffuse) ? bsdf.albedo(out).diffuse : Rgb{};
    Rgb L;
    for (std::uint32_t i = 0; i < photons.found.size; ++i) {
        const std::uint32_t p = photons.found.index[i];
        const Vec3 wi = point.frame.to_local(map_.direction(p));
        const float traced = traced_share(density(bsdf, out, wi), map_.tree().payload(p).breadth);
        const Rgb shiny = glossy_value(bsdf, out, wi, diffuse);
        const Rgb f = first ? bsdf.f(out, wi) - shiny * traced : shiny * (1 - traced);
        L += f * map_.flux(p) * photons.weight(i);
    }
    return L;
}

/// What a ray drawn from the glossy lobes finds.
Rgb GlossyCaustics::followed(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Sampler& sampler) const noexcept {
    const Vec3 out = point.frame.to_local(wo);
    const float u_lobe = sampler.next();
    const BsdfSample s = bsdf.sample(out, u_lobe, sampler.next2(), glossy);
    if (is_black(s.weight) || !is_finite(s.weight) || s.is_delta()) return {};
    const Vec3 wi = point.frame.to_world(s.wi);
    Walk walk{.ray = point.ray(wi),
              .medium = medium_towards(point, wi),
              .throughput = s.weight,
              .pdf = density(bsdf, out, s.wi)};
    while (walk.bounces < most_bounces && step(walk, sampler)) ++walk.bounces;
    return walk.sum;
}

/// One segment and the surface at its end; false where the ray ends.
bool GlossyCaustics::step(Walk& walk, Sampler& sampler) const noexcept {
    const Hit hit = world_.intersect(walk.ray);
    if (!hit.found()) {
        if (walk.bent) walk.sum += walk.throughput * far_lamps(walk);
        return false;
    }
    if (!is_black(walk.medium->absorption))
        walk.throughput *= exp(walk.medium->absorption * -static_cast<float>(hit.t));
    walk.length += hit.t;
    walk.last.distance += hit.t;
    const SurfacePoint point = world_.surface(walk.ray, hit);
    const Vec3 wo(-walk.ray.d);
    // What is met without a bend is direct light.
    if (walk.bent) walk.sum += walk.throughput * lamp(walk, point);
    if (point.lamp >= 0) return false;
    BsdfMemory memory;
    const Bsdf& bsdf = *world_.bsdf(point, memory);
    const Vec3 out = point.frame.to_local(wo);
    // What broad lobes send is no caustic.
    const Lobe lobes = bsdf.lobes() & (is_broad(bsdf, out) ? mirrors : followed_lobes);
    float share = 1;
    if (any(lobes & Lobe::glossy)) {
        share = traced_share(walk.pdf, lobe_breadth(bsdf, out, least_breadth_));
        const Rgb L = world_.direct(point, GlossyPart(bsdf, out), wo, sampler) + looked_up(point, bsdf, wo, false);
        walk.sum += walk.throughput * L * share;
    }
    return any(lobes & (Lobe::glossy | Lobe::specular)) && bounce(walk, point, bsdf, lobes, share, sampler);
}

/// Goes on by one of `lobes`; `share` is what photons have left of the light that comes by the glossy lobes.
bool GlossyCaustics::bounce(Walk& walk, const SurfacePoint& point, const Bsdf& bsdf, Lobe lobes, float share,
                            Sampler& sampler) const noexcept {
    const Vec3 out = point.frame.to_local(Vec3(-walk.ray.d));
    const float u_lobe = sampler.next();
    const BsdfSample s = bsdf.sample(out, u_lobe, sampler.next2(), lobes);
    walk.throughput *= s.weight;
    if (!s.is_delta()) walk.throughput *= share;
    if (is_black(walk.throughput) || !is_finite(walk.throughput)) return false;
    if (walk.bounces >= sure_bounces) {
        const float chance = std::min(best_chance, max_component(walk.throughput));
        if (!(sampler.next() < chance)) return false;
        walk.throughput *= 1 / chance;
    }
    const Vec3 wi = point.frame.to_world(s.wi);
    const bool straight = passes_filter(world_, point, out, s);
    const Vec3d unbent = walk.ray.d;
    walk.ray = point.ray(wi);
    walk.medium = medium_towards(point, wi);
    if (straight) {
        walk.ray.d = unbent;
    } else if (s.is_delta()) {
        walk.bent = true;
        walk.last = {point.p, wi};
    } else {
        walk.pdf = density(bsdf, out, s.wi);
        walk.length = 0;
        walk.bent = false;
    }
    return true;
}

/// Light of the lamp or emissive solid that the ray has met behind a mirror or glass.
Rgb GlossyCaustics::lamp(const Walk& walk, const SurfacePoint& point) const noexcept {
    const Rgb L = world_.emitted(point, Vec3(-walk.ray.d));
    const std::int32_t light = world_.light_of(point.id);
    if (is_black(L) || light < 0) return L;
    const Light& source = *world_.lights()[static_cast<std::size_t>(light)];
    return L * traced_share(walk.pdf, lamp_breadth(source, walk.last, walk.length));
}

/// The same of lights at infinity.
Rgb GlossyCaustics::far_lamps(const Walk& walk) const noexcept {
    FirstMirror last = walk.last;
    last.distance = std::numeric_limits<double>::infinity();
    const Vec3 d(walk.ray.d);
    Rgb sum;
    for (const auto& light : world_.lights()) {
        const Rgb L = light->escaped(d);
        if (!is_black(L)) sum += L * traced_share(walk.pdf, lamp_breadth(*light, last, 1));
    }
    return sum;
}

}  // namespace cardioid::photon

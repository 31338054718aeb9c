#include "photon/gather/incoming_light.hpp"

#include "photon/gather/glossy_part.hpp"
#include "photon/gather/side.hpp"
#include "photon/propagation/breadth.hpp"

namespace cardioid::photon {

namespace {

/// Mirrors and glass that a ray may meet, those met before the roulette begins, and the best chance to live then.
constexpr int most_bounces = 10'000, sure_bounces = 4;
constexpr float best_chance = 0.95F;
/// Lobes beside a diffuse one that send back such a share of light or more are always followed.
constexpr float sure_albedo = 0.25F;
/// Diffuse surfaces that are passed on the way to one that is far enough to be read from the map.
constexpr int most_near = 8;

constexpr Lobe followed = Lobe::glossy | Lobe::specular | Lobe::transmitted;

bool survives(Rgb& throughput, float chance, float u) {
    if (!(u < chance)) return false;
    throughput *= 1 / chance;
    return true;
}

}  // namespace

/// Where a ray is on its way.
struct IncomingLight::Walk {
    Vec3 wo;              ///< world, back along the ray
    double distance = 0;  ///< since the last diffuse surface
    int near = 0;         ///< diffuse surfaces passed
};

IncomingLight::Found IncomingLight::along(const SurfacePoint& point, Vec3 wi, Sampler& sampler) const noexcept {
    Found found;
    found.L = follow(point, wi, {}, sampler, found.distance);
    return found;
}

Rgb IncomingLight::follow(const SurfacePoint& start, Vec3 wi, Walk walk, Sampler& sampler,
                          double& first) const noexcept {
    Rgb sum, throughput(1);
    SurfacePoint point = start;
    for (int bounce = 0; bounce < most_bounces; ++bounce) {
        const Medium* medium = medium_towards(point, wi);
        const Ray ray = point.ray(wi);
        const Hit hit = world_.intersect(ray);
        if (bounce == 0) first = hit.t;
        if (!hit.found()) break;
        if (!is_black(medium->absorption)) throughput *= exp(medium->absorption * -static_cast<float>(hit.t));
        walk.distance += hit.t;
        point = world_.surface(ray, hit);
        if (point.lamp >= 0) break;
        walk.wo = -wi;
        BsdfMemory memory;
        const Bsdf* bsdf = world_.bsdf(point, memory);
        const Lobe lobes = bsdf->lobes() & way_on(*bsdf, point, walk, throughput, sampler);
        if (any(lobes & Lobe::diffuse)) sum += throughput * diffuse(point, *bsdf, walk, sampler);
        if (!any(lobes & (Lobe::glossy | Lobe::specular))) break;
        const Vec3 out = point.frame.to_local(walk.wo);
        if (!worth_following(*bsdf, out, throughput, sampler)) break;
        if (parts_.broad_apart && any(lobes & Lobe::glossy) && is_broad(*bsdf, out))
            sum += throughput * broad(point, *bsdf, walk.wo, sampler);
        const float u_lobe = sampler.next();
        const BsdfSample s = bsdf->sample(out, u_lobe, sampler.next2(), followed);
        throughput *= s.weight;
        if (is_black(throughput) || !is_finite(throughput)) break;
        if (bounce >= sure_bounces &&
            !survives(throughput, std::min(best_chance, max_component(throughput)), sampler.next()))
            break;
        wi = point.frame.to_world(s.wi);
    }
    return sum;
}

/// The lobes to follow: all, but a branch of a branch goes one way, or between near places that shine as well as
/// scatter rays would multiply with each of the many they pass.
Lobe IncomingLight::way_on(const Bsdf& bsdf, const SurfacePoint& point, const Walk& walk, Rgb& throughput,
                           Sampler& sampler) noexcept {
    const Lobe lobes = bsdf.lobes();
    if (walk.near == 0 || !any(lobes & Lobe::diffuse) || !any(lobes & (Lobe::glossy | Lobe::specular)))
        return Lobe::all;
    const Albedo albedo = bsdf.albedo(point.frame.to_local(walk.wo));
    const float diffuse = max_component(albedo.diffuse), other = max_component(albedo.specular + albedo.transmitted);
    if (!(diffuse > 0) || !(other > 0)) return Lobe::all;
    const float share = diffuse / (diffuse + other);
    const bool scatters = sampler.next() < share;
    throughput *= 1 / (scatters ? share : 1 - share);
    return scatters ? Lobe::diffuse : followed;
}

/// Roulette of what shines little: its diffuse lobe has most of the light.
bool IncomingLight::worth_following(const Bsdf& bsdf, Vec3 wo, Rgb& throughput, Sampler& sampler) noexcept {
    if (!any(bsdf.lobes() & Lobe::diffuse)) return true;
    const Albedo albedo = bsdf.albedo(wo);
    const float chance = max_component(albedo.specular + albedo.transmitted) / sure_albedo;
    return chance >= 1 || survives(throughput, chance, sampler.next());
}

/// Light from lamps and the caustic map that the broad lobes of a place send back along the ray.
Rgb IncomingLight::broad(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Sampler& sampler) const noexcept {
    const Vec3 out = point.frame.to_local(wo);
    const GlossyPart lobes(bsdf, out);
    Rgb L = world_.direct(point, lobes, wo, sampler);
    if (!parts_.caustics) return L;
    const auto from_side = [&](Vec3 ng) {
        return parts_.caustics->radiance(
            point, ng, parts_.caustic_lookup, [&](Vec3 wi) { return lobes.f(out, point.frame.to_local(wi)); }, &world_);
    };
    const Vec3 ng = geometric_normal(point, wo);
    L += from_side(ng);
    if (any(lobes.lobes() & Lobe::transmitted)) L += from_side(-ng);
    return L;
}

/// Light that the diffuse lobe of a place sends back along the ray.
Rgb IncomingLight::diffuse(const SurfacePoint& point, const Bsdf& bsdf, const Walk& walk,
                           Sampler& sampler) const noexcept {
    const Rgb albedo = bsdf.albedo(point.frame.to_local(walk.wo)).diffuse;
    if (is_black(albedo)) return {};
    const Vec3 ng = geometric_normal(point, walk.wo);
    if (!parts_.radiance)
        return parts_.map ? albedo * parts_.map->irradiance(point, ng, parts_.lookup, &world_, &bsdf).E * inv_pi
                          : Rgb{};
    if (parts_.always_near && walk.near == 0) return diffuse_nearby(point, {bsdf, albedo}, walk, sampler);
    const RadiancePayload* known = parts_.radiance->nearest(point, ng);
    const bool too_near = known && walk.distance < double{parts_.near * known->blur};
    if (walk.near < most_near && (!known || too_near)) return diffuse_nearby(point, {bsdf, albedo}, walk, sampler);
    return known ? albedo * known->E * inv_pi : Rgb{};
}

/// The same without a look at the radiance photons of this place: light from lamps, caustics, and one more ray.
Rgb IncomingLight::diffuse_nearby(const SurfacePoint& point, const DiffuseLobe& lobe, const Walk& walk,
                                  Sampler& sampler) const noexcept {
    const Rgb albedo = lobe.albedo({}).diffuse;
    Rgb L = world_.direct(point, lobe, walk.wo, sampler);
    if (parts_.caustics) {
        const Vec3 ng = geometric_normal(point, walk.wo);
        L += albedo * parts_.caustics->irradiance(point, ng, parts_.caustic_lookup, &world_, &lobe).E * inv_pi;
    }
    const float u_survive = sampler.next();
    const BsdfSample s = lobe.sample(point.frame.to_local(walk.wo), 0, sampler.next2(), Lobe::diffuse);
    Rgb throughput = s.weight;
    if (is_black(throughput) || !survives(throughput, std::min(1.0F, max_component(albedo)), u_survive)) return L;
    double ignored = 0;
    return L + throughput * follow(point, point.frame.to_world(s.wi), {.near = walk.near + 1}, sampler, ignored);
}

Rgb IncomingLight::scattered(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Lobe which,
                             Sampler& sampler) const noexcept {
    const float u_lobe = sampler.next();
    const BsdfSample s = bsdf.sample(point.frame.to_local(wo), u_lobe, sampler.next2(), which);
    if (is_black(s.weight) || s.is_delta()) return {};
    return s.weight * along(point, point.frame.to_world(s.wi), sampler).L;
}

Rgb IncomingLight::irradiance(const SurfacePoint& point, const Bsdf& bsdf, Vec3 n, int rays,
                              Sampler& sampler) const noexcept {
    const Frame frame(n);
    const bool outside = dot(n, point.ng) > 0;
    Rgb sum;
    for (int i = 0; i < rays; ++i) {
        const Vec3 wi = frame.to_world(sample_cosine_hemisphere(sampler.next2()));
        if ((dot(wi, point.ng) > 0) != outside) continue;
        const Rgb L = along(point, wi, sampler).L * bsdf.diffuse_acceptance(point.frame.to_local(wi));
        if (is_finite(L)) sum += L;  // as in a final gather: one broken material does not spoil what it faces
    }
    return sum * (pi / static_cast<float>(rays));
}

}  // namespace cardioid::photon

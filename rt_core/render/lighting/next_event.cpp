#include "rt_core/render/lighting/next_event.hpp"

#include <algorithm>

#include "rt_core/render/ray_counts.hpp"

namespace cardioid {

namespace {

/// Share of the draws that goes to all lights alike, so that a weak lamp close by is not forgotten.
constexpr float even_share = 0.1F;
/// Below this density [1/sr] somewhere, a light counts as wide.
constexpr float wide_pdf = 1;
/// Shadow rays end this share of their length before the lamp; a float direction misses by about 1e-7.
constexpr double before_lamp = 1 - 1e-5;
/// Filters that one ray may pass.
constexpr int most_filters = 10'000;

constexpr Lobe scattering = Lobe::diffuse | Lobe::glossy | Lobe::transmitted;

bool is_wide(const Light& light, Vec3d p) {
    for (unsigned i = 0; i < 16; ++i) {
        const Vec2 u{(static_cast<float>(i & 3) + 0.5F) / 4, (static_cast<float>(i >> 2) + 0.5F) / 4};
        const LightSample s = light.sample(p, u);
        if (s.trace || (!s.delta && std::isinf(s.distance) && s.pdf > 0 && s.pdf < wide_pdf)) return true;
    }
    return false;
}

const Medium* medium_towards(const SurfacePoint& point, Vec3 wi) noexcept {
    return dot(point.ng, wi) > 0 ? point.front : point.back;
}

}  // namespace

Rgb share_over(const Bsdf& bsdf, const Medium* medium, double distance) noexcept {
    Rgb share(std::isfinite(distance) ? bsdf.attenuation(distance) : 1);
    // Infinity times no absorption would be NaN.
    if (medium && !is_black(medium->absorption))
        share *= exp(medium->absorption * -static_cast<float>(std::min(distance, 1e30)));
    return share;
}

NextEvent::NextEvent(const World& world) : world_(world) {
    const auto lights = world.lights();
    for (const Material& m : world.materials()) filters_ = filters_ || m.shader->filters();
    const Vec3d centre = world.bounds().empty() ? Vec3d{} : world.bounds().centre();
    for (const auto& light : lights) {
        const LightSample s = light->sample(centre, {0.5F, 0.5F});
        found_by_rays_.push_back(!s.delta && light->casts_shadows() &&
                                 (s.trace || std::isinf(s.distance) || light->shape()));
        is_point_.push_back(s.delta && s.wi == light->sample(centre, {0.1F, 0.3F}).wi);
        wide_light_ = wide_light_ || (found_by_rays_.back() && is_wide(*light, centre));
    }
    if (lights.size() <= most_lights) return;
    double total = 0;
    for (const auto& light : lights) total += luminance(light->power());
    double sum = 0;
    const double even = 1.0 / static_cast<double>(lights.size());
    for (const auto& light : lights) {
        sum += total > 0 ? even_share * even + (1 - even_share) * luminance(light->power()) / total : even;
        light_cdf_.push_back(static_cast<float>(sum));
    }
    light_cdf_.back() = 1;
}

float NextEvent::draws(std::size_t light) const noexcept {
    if (light_cdf_.empty()) return 1;
    return most_lights * (light_cdf_[light] - (light == 0 ? 0 : light_cdf_[light - 1]));
}

template <class Use>
void NextEvent::look(const Ray& ray, Use&& use) const noexcept {
    ++ray_counts.shadow;
    Ray rest = ray;
    Rgb share(1);
    for (int i = 0; i < most_filters; ++i) {
        const Hit hit = world_.intersect(rest);
        if (!hit.found()) return use(static_cast<const SurfacePoint*>(nullptr), share);
        const bool light = world_.light_of(hit.id) >= 0;
        if (!light && !filters_) return;
        const SurfacePoint point = world_.surface(rest, hit);
        if (light) use(&point, share);
        if (!filters_ || point.lamp >= 0) return;
        share *= world_.materials()[point.material].shader->straight_transmittance(point,
                                                                                   point.frame.to_local(Vec3(-rest.d)));
        if (is_black(share)) return;
        rest = {point.p, rest.d, rest.t_max - hit.t, hit.id, hit.ng};
    }
}

Rgb NextEvent::arriving(const LightQuery& query, std::size_t light, const LightSample& sample) const noexcept {
    const Medium* medium = medium_towards(query.point, sample.wi);
    if (sample.trace) {
        Rgb L;
        look(query.point.ray(sample.wi), [&](const SurfacePoint* found, Rgb share) {
            if (found && world_.light_of(found->id) == static_cast<std::int32_t>(light))
                L += share * world_.emitted(*found, -sample.wi) *
                     share_over(query.bsdf, medium, length(found->p - query.point.p));
        });
        return L;
    }
    const Rgb L = sample.L * share_over(query.bsdf, medium, sample.distance);
    if (query.shadows)
        if (const auto lit = query.shadows->shadow(query.point, light)) return L * *lit;
    if (!world_.lights()[light]->casts_shadows()) return L;
    ++ray_counts.shadow;
    return L * world_.transmittance(query.point.ray(sample.wi, sample.distance * before_lamp));
}

Rgb NextEvent::sampled_light(const LightQuery& query, std::size_t light, float draws, Vec2 u) const noexcept {
    const LightSample s = world_.lights()[light]->sample(query.point.p, u);
    if (!(s.pdf > 0) || (!s.trace && is_black(s.L))) return {};
    const Vec3 wi = query.point.frame.to_local(s.wi);
    const Rgb f = query.bsdf.f(query.wo, wi) * std::abs(wi.z);
    if (is_black(f)) return {};
    const float pdf = s.pdf * draws;
    const float weight =
        any(query.tried) && found_by_rays_[light] ? power_heuristic(pdf, query.bsdf.pdf(query.wo, wi, query.tried)) : 1;
    if (weight == 0) return {};
    return f * arriving(query, light, s) * (weight / pdf);
}

Rgb NextEvent::sampled_bsdf(const LightQuery& query, Sampler& sampler) const noexcept {
    const float u_lobe = sampler.next();
    const BsdfSample s = query.bsdf.sample(query.wo, u_lobe, sampler.next2(), scattering);
    if (is_black(s.weight) || s.is_delta() || !(s.pdf > 0)) return {};
    const Vec3 wi = query.point.frame.to_world(s.wi);
    const Medium* medium = medium_towards(query.point, wi);
    const auto lights = world_.lights();
    Rgb L;
    const auto add = [&](std::size_t light, Rgb radiance) {
        if (!found_by_rays_[light] || is_black(radiance)) return;
        L += radiance * power_heuristic(s.pdf, lights[light]->pdf(query.point.p, wi) * draws(light));
    };
    look(query.point.ray(wi), [&](const SurfacePoint* found, Rgb share) {
        if (found)
            return add(
                static_cast<std::size_t>(world_.light_of(found->id)),
                share * world_.emitted(*found, -wi) * share_over(query.bsdf, medium, length(found->p - query.point.p)));
        share *= share_over(query.bsdf, medium, Box3d::infinity);
        for (std::size_t i = 0; i < lights.size(); ++i) add(i, share * lights[i]->escaped(wi));
    });
    return s.weight * L;
}

Rgb NextEvent::direct(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Sampler& sampler,
                      const LightingModule* shadows) const noexcept {
    const std::size_t count = found_by_rays_.size();
    if (count == 0 || bsdf.is_delta()) return {};
    // The choice depends on the scene and the Bsdf alone, never on numbers drawn.
    const bool both = wide_light_ || any(bsdf.lobes() & Lobe::glossy);
    const LightQuery query{point, bsdf, point.frame.to_local(wo), both ? scattering : Lobe::none, shadows};
    Rgb sum;
    if (light_cdf_.empty()) {
        for (std::size_t i = 0; i < count; ++i) sum += sampled_light(query, i, 1, sampler.next2());
    } else {
        const float first = sampler.next();
        for (std::size_t i = 0; i < most_lights; ++i) {
            const float u = (static_cast<float>(i) + first) / most_lights;
            const auto light = static_cast<std::size_t>(std::upper_bound(light_cdf_.begin(), light_cdf_.end() - 1, u) -
                                                        light_cdf_.begin());
            sum += sampled_light(query, light, draws(light), sampler.next2());
        }
    }
    return both ? sum + sampled_bsdf(query, sampler) : sum;
}

}  // namespace cardioid

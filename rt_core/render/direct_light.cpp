/// Next-event estimation. Each light is asked for a direction; where the Bsdf has glossy lobes, or some light is so
/// wide that its own sampling is poor, one direction of the Bsdf is traced too and both are weighted by the power
/// heuristic (Veach 1997, section 9.2). The choice depends on the scene and the Bsdf alone, never on numbers drawn.
#include "rt_core/render/committed_scene.hpp"
#include "rt_core/render/ray_counts.hpp"

namespace cardioid {

namespace {

/// Up to so many lights each is asked at every point; of more, so many are drawn.
constexpr std::size_t most_lights = 16;
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

}  // namespace

struct CommittedScene::DirectQuery {
    const SurfacePoint& point;
    const Bsdf& bsdf;
    Vec3 wo;    ///< local
    bool both;  ///< a direction of the Bsdf is traced too
    const LightingModule* shadows;
};

float CommittedScene::attenuation(const DirectQuery& query, double distance) noexcept {
    return std::isfinite(distance) ? query.bsdf.attenuation(distance) : 1;
}

void CommittedScene::plan_direct_light() {
    const Vec3d centre = bounds().empty() ? Vec3d{} : bounds().centre();
    found_by_rays_.assign(lights_.size(), false);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const LightSample s = lights_[i]->sample(centre, {0.5F, 0.5F});
        found_by_rays_[i] =
            !s.delta && lights_[i]->casts_shadows() && (s.trace || std::isinf(s.distance) || lights_[i]->shape());
        wide_light_ = wide_light_ || (found_by_rays_[i] && is_wide(*lights_[i], centre));
    }
    if (lights_.size() <= most_lights) return;
    double total = 0;
    for (const auto& light : lights_) total += luminance(light->power());
    double sum = 0;
    const double even = 1.0 / static_cast<double>(lights_.size());
    for (const auto& light : lights_) {
        sum += total > 0 ? even_share * even + (1 - even_share) * luminance(light->power()) / total : even;
        light_cdf_.push_back(static_cast<float>(sum));
    }
    light_cdf_.back() = 1;
}

std::int32_t CommittedScene::light_of(std::uint32_t id) const noexcept {
    const std::int32_t lamp = tracer_->lamp(id);
    return lamp >= 0 ? lamp_light_[static_cast<std::size_t>(lamp)] : region_light_[id];
}

float CommittedScene::draws(std::size_t light) const noexcept {
    if (light_cdf_.empty()) return 1;
    return most_lights * (light_cdf_[light] - (light == 0 ? 0 : light_cdf_[light - 1]));
}

template <class Use>
void CommittedScene::look(const Ray& ray, Use&& use) const noexcept {
    ++ray_counts.shadow;
    Ray rest = ray;
    Rgb share(1);
    for (int i = 0; i < most_filters; ++i) {
        const Hit hit = intersect(rest);
        if (!hit.found()) return use(static_cast<const SurfacePoint*>(nullptr), share);
        const bool light = light_of(hit.id.region) >= 0;
        if (!light && !filters_) return;
        const SurfacePoint point = surface(rest, hit);
        if (light) use(&point, share);
        if (!filters_ || point.lamp >= 0) return;
        share *= materials_[point.material].shader->straight_transmittance(point, point.frame.to_local(Vec3(-rest.d)));
        if (is_black(share)) return;
        rest = {point.p, rest.d, rest.t_max - hit.t, hit.id, hit.ng};
    }
}

Rgb CommittedScene::arriving(const DirectQuery& query, std::size_t light, const LightSample& sample) const noexcept {
    if (sample.trace) {
        Rgb L;
        look(query.point.ray(sample.wi), [&](const SurfacePoint* found, Rgb share) {
            if (found && light_of(found->id.region) == static_cast<std::int32_t>(light))
                L += share * emitted(*found, -sample.wi) * attenuation(query, length(found->p - query.point.p));
        });
        return L;
    }
    const Rgb L = sample.L * attenuation(query, sample.distance);
    if (query.shadows)
        if (const auto lit = query.shadows->shadow(query.point, light)) return L * *lit;
    if (!lights_[light]->casts_shadows()) return L;
    ++ray_counts.shadow;
    return L * transmittance(query.point.ray(sample.wi, sample.distance * before_lamp));
}

Rgb CommittedScene::sampled_light(const DirectQuery& query, std::size_t light, Vec2 u) const noexcept {
    const LightSample s = lights_[light]->sample(query.point.p, u);
    if (!(s.pdf > 0) || (!s.trace && is_black(s.L))) return {};
    const Vec3 wi = query.point.frame.to_local(s.wi);
    const Rgb f = query.bsdf.f(query.wo, wi) * std::abs(wi.z);
    if (is_black(f)) return {};
    const float pdf = s.pdf * draws(light);
    const float weight =
        query.both && found_by_rays_[light] ? power_heuristic(pdf, query.bsdf.pdf(query.wo, wi, scattering)) : 1;
    if (weight == 0) return {};
    return f * arriving(query, light, s) * (weight / pdf);
}

Rgb CommittedScene::sampled_bsdf(const DirectQuery& query, Sampler& sampler) const noexcept {
    const float u_lobe = sampler.next();
    const BsdfSample s = query.bsdf.sample(query.wo, u_lobe, sampler.next2(), scattering);
    if (is_black(s.weight) || s.is_delta() || !(s.pdf > 0)) return {};
    const Vec3 wi = query.point.frame.to_world(s.wi);
    Rgb L;
    const auto add = [&](std::size_t light, Rgb radiance) {
        if (!found_by_rays_[light] || is_black(radiance)) return;
        L += radiance * power_heuristic(s.pdf, lights_[light]->pdf(query.point.p, wi) * draws(light));
    };
    look(query.point.ray(wi), [&](const SurfacePoint* found, Rgb share) {
        if (found)
            return add(static_cast<std::size_t>(light_of(found->id.region)),
                       share * emitted(*found, -wi) * attenuation(query, length(found->p - query.point.p)));
        for (std::size_t i = 0; i < lights_.size(); ++i) add(i, share * lights_[i]->escaped(wi));
    });
    return s.weight * L;
}

Rgb CommittedScene::direct(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Sampler& sampler,
                           const LightingModule* shadows) const noexcept {
    if (lights_.empty() || bsdf.is_delta()) return {};
    const bool both = wide_light_ || any(bsdf.lobes() & Lobe::glossy);
    const DirectQuery query{point, bsdf, point.frame.to_local(wo), both, shadows};
    Rgb sum;
    if (light_cdf_.empty()) {
        for (std::size_t i = 0; i < lights_.size(); ++i) sum += sampled_light(query, i, sampler.next2());
    } else {
        const float first = sampler.next();
        for (std::size_t i = 0; i < most_lights; ++i) {
            const float u = (static_cast<float>(i) + first) / most_lights;
            const auto light = std::upper_bound(light_cdf_.begin(), light_cdf_.end() - 1, u) - light_cdf_.begin();
            sum += sampled_light(query, static_cast<std::size_t>(light), sampler.next2());
        }
    }
    return both ? sum + sampled_bsdf(query, sampler) : sum;
}

}  // namespace cardioid

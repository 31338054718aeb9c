#include "rt_core/render/lighting/light_path.hpp"

#include <limits>

#include "rt_core/render/lighting/roulette.hpp"
#include "rt_core/render/ray_counts.hpp"

namespace cardioid {

namespace {

/// A path goes on for sure while it carries at least the inverse of this. Measured on the Cornell box: error^2 times
/// time is the same within a few per cent from 1.5 to 4, at 1 half as much again.
constexpr float patience = 1.5F;
/// What mirrors and media on the way to the first point of finite lobes have taken does not count, for it is taken from
/// the whole pixel: without dice a view through dark glass has no noise. What is darker than this counts.
constexpr float least_first = 1e-3F;

}  // namespace

LightParts LightPath::from_eye(const EyeRay& eye) noexcept {
    ray_ = eye.ray;
    medium_ = eye.medium;
    pixel_ = eye.pixel, spread_ = eye.spread;
    follow();
    return parts_;
}

LightParts LightPath::from_point(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, bool caustic_only) noexcept {
    if (settings_.depth < 1) return {};
    caustic_only_ = caustic_only;
    SurfacePoint start = point;
    if (!start.front) start.front = world_.medium_at(point.p);
    if (!start.back) start.back = start.front;
    medium_ = dot(start.ng, wo) > 0 ? start.front : start.back;
    if (bounce(start, bsdf, start.frame.to_local(wo), Lobe::diffuse | Lobe::glossy | Lobe::transmitted)) follow();
    return parts_;
}

void LightPath::follow() noexcept {
    while (step()) {
    }
}

/// One segment and the surface at its end; false where the path ends.
bool LightPath::step() noexcept {
    if (bounces_ > settings_.depth) return false;
    const Hit hit = world_.intersect(ray_);
    if (!is_black(medium_->absorption))
        throughput_ *= exp(medium_->absorption * -static_cast<float>(std::min(hit.t, 1e30)));
    if (!hit.found()) {
        escape();
        return false;
    }
    SurfacePoint point = world_.surface(ray_, hit);
    if (stage_ == Stage::eye || stage_ == Stage::behind) {
        distance_ += hit.t;
        point.footprint = pixel_ + spread_ * distance_;
    }
    const Vec3 wo(-ray_.d);
    arrive(point, wo);
    if (point.lamp >= 0) return false;
    const bool last = bounces_ >= settings_.depth;
    if (last && !filters(point)) return false;
    const Bsdf* bsdf = world_.bsdf(point, memories_[memory_]);
    const Vec3 wo_local = point.frame.to_local(wo);
    const bool straight = last || caustic_only_;
    if (!straight && any(bsdf->lobes() & (Lobe::diffuse | Lobe::glossy))) ask_light(point, *bsdf, wo_local);
    return bounce(point, *bsdf, wo_local, straight ? Lobe::specular | Lobe::transmitted : Lobe::all);
}

bool LightPath::filters(const SurfacePoint& point) const noexcept {
    return world_.materials()[point.material].shader->filters();
}

void LightPath::add(Rgb L) noexcept {
    switch (stage_) {
        case Stage::eye:
            parts_.emission += L;
            break;
        case Stage::behind:
            parts_.specular += L;
            break;
        case Stage::direct:
            parts_.direct += L;
            break;
        case Stage::caustic:
            parts_.caustic += L;
            break;
        case Stage::indirect:
            parts_.indirect += L;
            break;
    }
}

/// How much of what this ray finds of a light counts, beside what was asked of it.
float LightPath::share_of_ray(std::size_t light) const noexcept {
    if (!next_event_.found_by_rays(light)) return 0;
    const float pdf = world_.lights()[light]->pdf(asked_, Vec3(ray_.d));
    return power_heuristic(ray_pdf_, pdf * choice_.chance(asked_, light));
}

void LightPath::arrive(const SurfacePoint& point, Vec3 wo) noexcept {
    const Rgb L = world_.emitted(point, wo);
    if (is_black(L)) return;
    if (ray_pdf_ == 0) return add(throughput_ * L);
    const std::int32_t light = world_.light_of(point.id);
    const float share = light < 0 ? 1 : share_of_ray(static_cast<std::size_t>(light));
    if (share > 0) add(throughput_ * L * (share * asked_bsdf_->attenuation(length(point.p - asked_))));
}

void LightPath::escape() noexcept {
    const auto lights = world_.lights();
    const Vec3 d(ray_.d);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const Rgb L = unbent_ ? lights[i]->backdrop(d) : lights[i]->escaped(d);
        if (!is_black(L)) add(throughput_ * L * (ray_pdf_ == 0 ? 1 : share_of_ray(i)));
    }
}

void LightPath::ask_light(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo_local) noexcept {
    const LightChoice::Choice choice = choice_.choose(point.p, choice_.several() ? sampler_.next() : 0);
    if (!(choice.chance > 0)) return;
    const LightQuery query{point, bsdf, wo_local, Lobe::all, nullptr};
    const Rgb L = throughput_ * next_event_.sampled_light(query, choice.light, choice.chance, sampler_.next2());
    if (stage_ == Stage::eye)
        parts_.direct += L;
    else if (stage_ == Stage::behind)
        parts_.specular += L;
    else
        parts_.indirect += L;
}

bool LightPath::survives() noexcept {
    const float carried = max_component(throughput_) * squeeze_ * per_first_ * patience;
    const float chance = std::min(carried, best_chance(steps_));
    if (chance >= 1) return true;
    // A pair of numbers serves two bounces.
    if (!has_spare_) spare_ = sampler_.next2();
    has_spare_ = !has_spare_;
    if (!((has_spare_ ? spare_.x : spare_.y) < chance)) return false;
    throughput_ *= 1 / chance;
    return true;
}

/// Goes on in a direction of the Bsdf.
bool LightPath::bounce(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo_local, Lobe which) noexcept {
    const float u_lobe = bsdf.lobes() == Lobe::diffuse ? 0 : sampler_.next();
    const BsdfSample s = bsdf.sample(wo_local, u_lobe, sampler_.next2(), which);
    if (is_black(s.weight)) return false;
    const bool delta = s.is_delta();
    if (!delta && !(s.pdf > 0)) return false;
    const Rgb arrived = throughput_;
    throughput_ *= s.weight;
    if (!is_finite(throughput_) || min_component(throughput_) < 0) {
        add(throughput_);  // for the renderer to see and to count
        return false;
    }
    const Vec3 wi = point.frame.to_world(s.wi);
    const Medium* next = dot(point.ng, wi) > 0 ? point.front : point.back;
    if (next != medium_) {
        const float ratio = next->ior / medium_->ior;
        squeeze_ *= ratio * ratio;
        medium_ = next;
    }
    if (!asked_bsdf_) per_first_ = 1 / std::max(max_component(delta ? throughput_ : arrived) * squeeze_, least_first);
    if (!survives()) return false;

    const bool through = delta && s.wi == -wo_local;
    // As point.ray(wi), part by part: copying a ray that has just been put together waits for its parts.
    if (!through) ray_.d = Vec3d(wi);
    ray_.o = point.p;
    ray_.t_max = std::numeric_limits<double>::infinity();
    ray_.from = point.id;
    ray_.from_ng = point.ng;
    ++ray_counts.bounce;
    ++steps_;
    unbent_ = unbent_ && through;
    // Shadow rays pass filters, so a filter is no bounce, and what is found behind it is weighed as if it were not
    // there.
    const bool filtered = through && filters(point);
    if (!filtered) ++bounces_;
    if (!delta) {
        stage_ = stage_ == Stage::eye ? Stage::direct : stage_ == Stage::behind ? Stage::behind : Stage::indirect;
        asked_ = point.p;
        asked_bsdf_ = &bsdf;
        ray_pdf_ = s.pdf;
        memory_ = 1 - memory_;
    } else if (stage_ == Stage::eye) {
        stage_ = Stage::behind;
    } else if (!filtered) {
        if (stage_ == Stage::direct) stage_ = Stage::caustic;
        ray_pdf_ = 0;
    }
    return true;
}

}  // namespace cardioid

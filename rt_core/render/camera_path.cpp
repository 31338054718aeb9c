#include "rt_core/render/camera_path.hpp"

#include <utility>

#include "rt_core/render/ray_counts.hpp"

namespace cardioid {

namespace {

/// Specular bounces before Russian roulette begins, the best chance to live on then, and where a path ends anyway.
constexpr int sure_bounces = 4, most_bounces = 10'000;
constexpr float best_chance = 0.99F;
/// A chain goes on for sure while it carries more than the inverse of this: one that carries a little and is raised to
/// the whole of what the eye gets is a speck where it meets a lamp.
constexpr float patience = 32;

Rgb transmitted(const Medium& medium, double length) {
    if (is_black(medium.absorption)) return Rgb(1);
    // Infinity times no absorption would be NaN.
    const float t = static_cast<float>(std::min(length, 1e30));
    return exp(medium.absorption * -t);
}

/// Of so many boundaries both ways are followed, if the weaker one keeps this share of what the eye gets; later one of
/// them by chance. Reflections of lamps in glass are bright and rare, and would be specks.
constexpr int most_splits = 3;
constexpr float least_share = 1e-3F;
/// The last of the numbers that choose a lobe.
constexpr float last_choice = 1 - 0x1p-24F;

constexpr Lobe followed = Lobe::specular | Lobe::transmitted;

/// The mirrored and the transmitted way of a boundary, each with its whole weight; black where there are not two.
struct BothWays {
    BsdfSample mirrored, through;

    BothWays(const Bsdf& bsdf, Vec3 wo, Vec2 u) noexcept {
        BsdfSample first = bsdf.sample(wo, 0, u, followed), last = bsdf.sample(wo, last_choice, u, followed);
        if (any(first.lobe & Lobe::transmitted)) std::swap(first, last);
        const float weight = max_component(first.weight);
        if (any(first.lobe & Lobe::transmitted) || !any(last.lobe & Lobe::transmitted) || !(weight > 0)) return;
        // What the mirror reflects by itself is its weight times the chance that it is chosen.
        const float chance = max_component(bsdf.sample(wo, 0, u, Lobe::specular).weight) / weight;
        if (!(chance > 0 && chance < 1)) return;
        mirrored = first, through = last;
        mirrored.weight *= chance;
        through.weight *= 1 - chance;
    }
    [[nodiscard]] float weaker() const noexcept {
        return std::min(max_component(mirrored.weight), max_component(through.weight));
    }
};

/// Follows the specular chains that begin at the eye. The derived class is told of what is on their way:
/// add_light(L) of light met, scatter(point, bsdf, wo) of points with lobes of finite width.
template <class Derived>
class Path {
public:
    Path(const CommittedScene& scene, const EyeRay& camera, Sampler& sampler)
        : scene_(scene), sampler_(sampler), camera_(camera), at_{.ray = camera.ray, .medium = camera.medium} {}

    void follow() noexcept {
        for (;;) {
            while (at_.bounces < most_bounces && step()) ++at_.bounces;
            if (waiting_count_ == 0) return;
            at_ = waiting_[--waiting_count_];
        }
    }

protected:
    /// The end of a chain so far.
    struct Place {
        Ray ray;
        const Medium* medium;
        Rgb throughput{1};
        double distance = 0;
        int bounces = 0, splits = 0;
        bool straight = true;  ///< nothing has bent the ray yet, so it shows the backdrop
    };

    [[nodiscard]] Rgb throughput() const noexcept { return at_.throughput; }
    [[nodiscard]] int bounces() const noexcept { return at_.bounces; }

    const CommittedScene& scene_;
    Sampler& sampler_;

private:
    [[nodiscard]] Derived& derived() noexcept { return static_cast<Derived&>(*this); }

    /// One segment and the surface at its end; false where the chain ends.
    bool step() noexcept {
        const Hit hit = scene_.intersect(at_.ray);
        at_.throughput *= transmitted(*at_.medium, hit.t);
        if (!hit.found()) {
            const Vec3 d(at_.ray.d);
            derived().add_light(at_.straight ? scene_.backdrop(d) : scene_.escaped(d));
            return false;
        }
        at_.distance += hit.t;
        SurfacePoint point = scene_.surface(at_.ray, hit);
        point.footprint = camera_.pixel + camera_.spread * at_.distance;
        const Vec3 wo(-at_.ray.d);
        derived().add_light(scene_.emitted(point, wo));
        if (point.lamp >= 0) return false;
        BsdfMemory memory;
        const Bsdf* bsdf = scene_.bsdf(point, memory);
        if (!bsdf->is_delta()) derived().scatter(point, *bsdf, wo);
        return any(bsdf->lobes() & Lobe::specular) && bounce(point, *bsdf, wo);
    }

    /// Goes on by a delta lobe; false where there is none or the roulette is lost.
    bool bounce(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo) noexcept {
        const Vec3 wo_local = point.frame.to_local(wo);
        if (at_.splits < most_splits && any(bsdf.lobes() & Lobe::transmitted)) {
            const BothWays both(bsdf, wo_local, sampler_.next2());
            if (both.weaker() * max_component(at_.throughput) > least_share) {
                ++at_.splits;
                Place& other = waiting_[waiting_count_++] = at_;
                leave(other, point, wo_local, both.mirrored);
                ++other.bounces;
                leave(at_, point, wo_local, both.through);
                return true;
            }
        }
        const float u_lobe = sampler_.next();
        const BsdfSample s = bsdf.sample(wo_local, u_lobe, sampler_.next2(), followed);
        if (is_black(at_.throughput * s.weight)) return false;
        leave(at_, point, wo_local, s);
        if (at_.bounces < sure_bounces) return true;
        const float chance = std::min(best_chance, patience * carried());
        at_.throughput *= 1 / chance;
        return sampler_.next() < chance;
    }

    /// What of the eye's radiance the chain carries. Radiance is denser within glass and loses that where it leaves.
    [[nodiscard]] float carried() const noexcept {
        const float squeeze = at_.medium->ior / camera_.medium->ior;
        return max_component(at_.throughput) * squeeze * squeeze;
    }

    static void leave(Place& place, const SurfacePoint& point, Vec3 wo_local, const BsdfSample& s) noexcept {
        place.throughput *= s.weight;
        const Vec3 wi = point.frame.to_world(s.wi);
        place.medium = dot(point.ng, wi) > 0 ? point.front : point.back;
        // A filter does not bend the ray at all: rounding must not either.
        const bool unbent = s.wi == -wo_local;
        place.straight = place.straight && unbent;
        const Vec3d d = unbent ? place.ray.d : Vec3d(wi);
        place.ray = point.ray(wi);
        place.ray.d = d;
        ++ray_counts.specular;
    }

    const EyeRay& camera_;
    Place at_;
    Place waiting_[most_splits];
    int waiting_count_ = 0;
};

/// Gathers light into picture layers.
class LightPath final : public Path<LightPath> {
public:
    LightPath(const CommittedScene& scene, const LightingModule& module, const EyeRay& camera, Sampler& sampler)
        : Path(scene, camera, sampler), module_(module) {}

    [[nodiscard]] const LightParts& parts() const noexcept { return parts_; }
    void add_light(Rgb L) noexcept { add(&LightParts::emission, L); }
    void scatter(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo) noexcept {
        add(&LightParts::direct, scene_.direct(point, bsdf, wo, sampler_, &module_));
        add(&LightParts::caustic, module_.caustic(scene_, point, bsdf, wo, sampler_));
        add(&LightParts::indirect, module_.indirect(scene_, point, bsdf, wo, sampler_));
    }

private:
    void add(Rgb LightParts::*part, Rgb L) noexcept {
        (bounces() == 0 ? parts_.*part : parts_.specular) += throughput() * L;
    }

    const LightingModule& module_;
    LightParts parts_;
};

/// Only looks.
class SightPath final : public Path<SightPath> {
public:
    SightPath(const CommittedScene& scene, const EyeRay& camera, Sampler& sampler,
              const std::function<void(const Eye::Sight&)>& see)
        : Path(scene, camera, sampler), see_(see) {}

    void add_light(Rgb) noexcept {}
    void scatter(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo) noexcept {
        see_({point, bsdf, wo, throughput(), bounces()});
    }

private:
    const std::function<void(const Eye::Sight&)>& see_;
};

}  // namespace

std::optional<FirstHit> first_hit(const CommittedScene& scene, const EyeRay& camera) noexcept {
    const Hit hit = scene.intersect(camera.ray);
    if (!hit.found()) return std::nullopt;
    FirstHit first;
    first.distance = hit.t;
    first.point = scene.surface(camera.ray, hit);
    first.point.footprint = camera.pixel + camera.spread * hit.t;
    BsdfMemory memory;
    first.albedo = scene.bsdf(first.point, memory)->albedo(first.point.frame.to_local(Vec3(-camera.ray.d)));
    return first;
}

LightParts light_along(const CommittedScene& scene, const LightingModule& module, const EyeRay& camera,
                       Sampler& sampler) noexcept {
    if (const auto all = module.incoming(scene, camera, sampler)) return *all;
    LightPath path(scene, module, camera, sampler);
    path.follow();
    return path.parts();
}

void look_along(const CommittedScene& scene, const EyeRay& camera, Sampler& sampler,
                const std::function<void(const Eye::Sight&)>& see) {
    SightPath(scene, camera, sampler, see).follow();
}

}  // namespace cardioid

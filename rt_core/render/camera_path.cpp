#include "rt_core/render/camera_path.hpp"

#include "rt_core/render/ray_counts.hpp"

namespace cardioid {

namespace {

/// Specular bounces before Russian roulette begins, the best chance to live on then, and where a path ends anyway.
constexpr int sure_bounces = 4, most_bounces = 10'000;
constexpr float best_chance = 0.99F;

Rgb transmitted(const Medium& medium, double length) {
    if (is_black(medium.absorption)) return Rgb(1);
    // Infinity times no absorption would be NaN.
    const float t = static_cast<float>(std::min(length, 1e30));
    return exp(medium.absorption * -t);
}

/// Follows the specular chain that begins at the eye. The derived class is told of what is on its way:
/// add_light(L) of light met, scatter(point, bsdf, wo) of points with lobes of finite width.
template <class Derived>
class Path {
public:
    Path(const CommittedScene& scene, const EyeRay& camera, Sampler& sampler)
        : scene_(scene), sampler_(sampler), camera_(camera), ray_(camera.ray), medium_(camera.medium) {}

    void follow() noexcept {
        for (bounces_ = 0; bounces_ < most_bounces; ++bounces_)
            if (!step()) break;
    }

protected:
    const CommittedScene& scene_;
    Sampler& sampler_;
    Rgb throughput_{1};
    int bounces_ = 0;

private:
    [[nodiscard]] Derived& derived() noexcept { return static_cast<Derived&>(*this); }

    /// One segment and the surface at its end; false where the path ends.
    bool step() noexcept {
        const Hit hit = scene_.intersect(ray_);
        throughput_ *= transmitted(*medium_, hit.t);
        if (!hit.found()) {
            const Vec3 d(ray_.d);
            derived().add_light(straight_ ? scene_.backdrop(d) : scene_.escaped(d));
            return false;
        }
        distance_ += hit.t;
        SurfacePoint point = scene_.surface(ray_, hit);
        point.footprint = camera_.pixel + camera_.spread * distance_;
        const Vec3 wo(-ray_.d);
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
        const float u_lobe = sampler_.next();
        const BsdfSample s = bsdf.sample(wo_local, u_lobe, sampler_.next2(), Lobe::specular | Lobe::transmitted);
        throughput_ *= s.weight;
        if (is_black(throughput_)) return false;
        if (bounces_ >= sure_bounces) {
            const float chance = std::min(best_chance, max_component(throughput_));
            if (!(sampler_.next() < chance)) return false;
            throughput_ *= 1 / chance;
        }
        const Vec3 wi = point.frame.to_world(s.wi);
        medium_ = dot(point.ng, wi) > 0 ? point.front : point.back;
        // A filter does not bend the ray at all: rounding must not either.
        const bool unbent = s.wi == -wo_local;
        straight_ = straight_ && unbent;
        const Vec3d d = unbent ? ray_.d : Vec3d(wi);
        ray_ = point.ray(wi);
        ray_.d = d;
        ++ray_counts.specular;
        return true;
    }

    const EyeRay& camera_;
    Ray ray_;
    const Medium* medium_;
    double distance_ = 0;
    bool straight_ = true;  ///< nothing has bent the ray yet, so it shows the backdrop
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
        (bounces_ == 0 ? parts_.*part : parts_.specular) += throughput_ * L;
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
        see_({point, bsdf, wo, throughput_, bounces_});
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

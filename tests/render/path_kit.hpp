#pragma once
#include <cmath>

#include "scene_kit.hpp"

#include "rt_core/render/lighting/path_lighting.hpp"

namespace cardioid::test {

/// Samples in a row that share one well-spread sequence. Only sequences are independent of each other, and their means
/// err by less than those of independent samples.
inline constexpr std::uint32_t batch = 256;

/// Mean and standard error of numbers that come one by one, `group` of them at a time being one independent number.
class Moments {
public:
    explicit Moments(std::uint32_t group = batch) : group_(group) {}
    void add(double x) {
        sum_ += x;
        if (++in_group_ < group_) return;
        ++n_;
        const double mean = sum_ / group_, d = mean - mean_;
        mean_ += d / n_;
        squares_ += d * (mean - mean_);
        sum_ = 0, in_group_ = 0;
    }
    [[nodiscard]] double mean() const { return mean_; }
    [[nodiscard]] double error() const { return std::sqrt(squares_ / (n_ - 1) / n_); }
    /// How many standard errors the mean is away from `wanted`, whose own standard error is `other`.
    [[nodiscard]] double z(double wanted, double other = 0) const {
        return std::abs(mean_ - wanted) / std::max(std::hypot(error(), other), 1e-6 * std::abs(wanted) + 1e-30);
    }

private:
    std::uint32_t group_, in_group_ = 0;
    double sum_ = 0, n_ = 0, mean_ = 0, squares_ = 0;
};

/// |z| beyond which p < 1e-4, two-sided, for means of 40 batches and more (Student's t).
inline constexpr double largest_z = 4.3;

/// The mean is `wanted`, itself known to a standard error of `other`.
inline void expect_agreement(const Moments& found, double wanted, const std::string& what, double other = 0) {
    EXPECT_LT(found.z(wanted, other), largest_z)
        << what << ": " << found.mean() << " +- " << found.error() << " for " << wanted << " +- " << other;
}

/// The same, and an error of 2 % would be seen.
inline void expect_mean(const Moments& found, double wanted, const std::string& what, double other = 0) {
    expect_agreement(found, wanted, what, other);
    EXPECT_GT(found.z(wanted * 1.02, other), largest_z)
        << what << " does not see 2 %: " << found.mean() << " +- " << std::hypot(found.error(), other);
}

/// `path` prepared for a scene, and what it says of rays and points.
class PathKit {
public:
    explicit PathKit(const CommittedScene& scene, std::initializer_list<std::pair<const char*, double>> options = {})
        : scene_(scene) {
        Params params("--set");
        for (const auto& [name, value] : options) params.set(name, value);
        module_ = path_lighting.make(params, 0);
        Progress progress;
        module_->prepare(scene, nullptr, progress);
    }
    [[nodiscard]] const LightingModule& module() const { return *module_; }

    /// Samples of the light along a ray, in batches; use(LightParts) for each.
    template <class Use>
    void along(Vec3d o, Vec3d d, std::uint32_t samples, Use&& use) const {
        const EyeRay eye{{o, normalize(d), Box3d::infinity, {}, {}}, scene_.medium_at(o)};
        for (std::uint32_t i = 0; i < samples; ++i) {
            Sampler sampler(5, Purpose::test, i / batch, i % batch);
            use(*module_->incoming(scene_, eye, sampler));
        }
    }
    /// Green radiance along a ray.
    [[nodiscard]] Moments radiance(Vec3d o, Vec3d d, std::uint32_t samples) const {
        Moments sum;
        along(o, d, samples, [&](const LightParts& parts) { sum.add(static_cast<double>(parts.sum().g)); });
        return sum;
    }
    /// Green parts of what leaves the point that the ray meets first, asked for one by one.
    struct AtPoint {
        Moments direct, caustic, indirect, sum;
    };
    [[nodiscard]] AtPoint at_point(Vec3d o, Vec3d d, std::uint32_t samples) const {
        const SurfacePoint point = seen(scene_, o, d);
        BsdfMemory memory;
        const Bsdf* bsdf = scene_.bsdf(point, memory);
        const Vec3 wo(normalize(-d));
        AtPoint out;
        for (std::uint32_t i = 0; i < samples; ++i) {
            Sampler sampler(6, Purpose::test, i / batch, i % batch);
            const double a = static_cast<double>(scene_.direct(point, *bsdf, wo, sampler).g);
            const double b = static_cast<double>(module_->caustic(scene_, point, *bsdf, wo, sampler).g);
            const double c = static_cast<double>(module_->indirect(scene_, point, *bsdf, wo, sampler).g);
            out.direct.add(a), out.caustic.add(b), out.indirect.add(c), out.sum.add(a + b + c);
        }
        return out;
    }

private:
    const CommittedScene& scene_;
    std::unique_ptr<LightingModule> module_;
};

/// The plainest path tracer: directions of the Bsdf alone, no light is asked, nothing is weighed.
inline double brute_force(const CommittedScene& scene, Ray ray, Sampler& sampler, int depth = 1000) {
    double sum = 0;
    Rgb throughput(1);
    const Medium* medium = scene.medium_at(ray.o);
    bool unbent = true;
    for (int bounces = 0;; ++bounces) {
        const Hit hit = scene.intersect(ray);
        throughput *= exp(medium->absorption * -static_cast<float>(std::min(hit.t, 1e30)));
        if (!hit.found()) {
            const Vec3 d(ray.d);
            return sum + static_cast<double>((throughput * (unbent ? scene.backdrop(d) : scene.escaped(d))).g);
        }
        const SurfacePoint point = scene.surface(ray, hit);
        const Vec3 wo(-ray.d);
        sum += static_cast<double>((throughput * scene.emitted(point, wo)).g);
        if (point.lamp >= 0 || bounces == depth) return sum;
        BsdfMemory memory;
        const Vec2 u = sampler.next2();
        const Vec3 wo_local = point.frame.to_local(wo);
        const BsdfSample s = scene.bsdf(point, memory)->sample(wo_local, u.x, sampler.next2());
        throughput *= s.weight;
        if (is_black(throughput)) return sum;
        if (bounces > 5) {
            if (u.y >= 0.8F) return sum;
            throughput *= 1 / 0.8F;
        }
        const Vec3 wi = point.frame.to_world(s.wi);
        medium = dot(point.ng, wi) > 0 ? point.front : point.back;
        const bool through = s.wi == -wo_local;
        const Vec3d d = through ? ray.d : Vec3d(wi);
        unbent = unbent && through;
        ray = point.ray(wi);
        ray.d = d;
    }
}

}  // namespace cardioid::test

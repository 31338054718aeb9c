#include "rt_core/render/lighting/direct_lighting.hpp"

#include "rt_core/render/lighting/roulette.hpp"

namespace cardioid {

namespace {

/// Bounces after which Russian roulette begins, and where a path ends in any case.
constexpr int sure_bounces = 3, most_bounces = 10'000;

const Medium* beyond(const SurfacePoint& point, Vec3 wi) { return dot(point.ng, wi) > 0 ? point.front : point.back; }

/// A Bsdf whose values are cut off at twice a white diffuse surface's. Highlights seen in rough metal are caustics:
/// small, bright, and found by a few samples only, so that without maps or long sampling they would be specks.
class SoftHighlights final : public Bsdf {
public:
    explicit SoftHighlights(const Bsdf& bsdf) : bsdf_(bsdf) {}
    [[nodiscard]] Lobe lobes() const noexcept override { return bsdf_.lobes(); }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override {
        const Rgb f = bsdf_.f(wo, wi);
        return f * cut(f);
    }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override { return bsdf_.pdf(wo, wi, which); }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float u_lobe, Vec2 u, Lobe which) const noexcept override {
        BsdfSample s = bsdf_.sample(wo, u_lobe, u, which);
        if (!s.is_delta()) s.weight *= cut(bsdf_.f(wo, s.wi));
        return s;
    }
    [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept override { return bsdf_.albedo(wo); }
    [[nodiscard]] float attenuation(double distance) const noexcept override { return bsdf_.attenuation(distance); }

private:
    static float cut(Rgb f) noexcept { return std::min(1.0F, 2 * inv_pi / std::max(max_component(f), 1e-30F)); }
    const Bsdf& bsdf_;
};

/// Surfaces that diffuse light do not light each other here. A glossy one still shows what stands around it, or rough
/// metal would be black: its lobe is followed until the path ends. Light that such a path finds at its source has been
/// counted by World::direct, and behind further mirrors it is a caustic, which this module has none of.
class DirectLighting final : public LightingModule {
public:
    [[nodiscard]] Rgb indirect(const World& world, const SurfacePoint& start, const Bsdf& bsdf, Vec3 wo,
                               Sampler& sampler) const noexcept override {
        if (!any(bsdf.lobes() & Lobe::glossy)) return {};
        Rgb sum, throughput(1);
        SurfacePoint point = start;
        BsdfMemory memory[2];
        const Bsdf* here = &bsdf;
        Lobe which = Lobe::glossy | Lobe::transmitted;
        for (int bounce = 0; bounce < most_bounces; ++bounce) {
            const float u_lobe = sampler.next();
            const BsdfSample s = here->sample(point.frame.to_local(wo), u_lobe, sampler.next2(), which);
            throughput *= s.weight;
            if (is_black(throughput) || !survives(bounce, throughput, sampler)) break;
            const Vec3 wi = point.frame.to_world(s.wi);
            const Ray ray = point.ray(wi);
            const Hit hit = world.intersect(ray);
            if (!hit.found()) break;
            throughput *= exp(beyond(point, wi)->absorption * -static_cast<float>(hit.t));
            point = world.surface(ray, hit);
            if (point.lamp >= 0) break;
            wo = -wi;
            // Two memories in turn: the Bsdf just left is needed no more.
            here = world.bsdf(point, memory[bounce % 2]);
            if (!here->is_delta()) sum += throughput * world.direct(point, SoftHighlights(*here), wo, sampler);
            which = Lobe::glossy | Lobe::specular | Lobe::transmitted;
        }
        return sum;
    }

private:
    static bool survives(int bounce, Rgb& throughput, Sampler& sampler) noexcept {
        if (bounce < sure_bounces) return true;
        const float chance = std::min(best_chance(bounce), max_component(throughput));
        throughput *= 1 / chance;
        return sampler.next() < chance;
    }
};

std::unique_ptr<LightingModule> make(const Params&, std::uint32_t) { return std::make_unique<DirectLighting>(); }

}  // namespace

const LightingKind direct_lighting{
    "direct", "light straight from its sources, mirrors, glass and glossy surfaces", {}, make};

}  // namespace cardioid

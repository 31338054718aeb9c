#include "rt_core/render/lighting/whitted_lighting.hpp"

#include <cstddef>
#include <new>

#include "rt_core/render/lighting/next_event.hpp"
#include "rt_core/render/ray_counts.hpp"

namespace cardioid {

namespace {

/// Mirrors and surfaces of glass that one way may pass, and the share of its light below which it ends. POV-Ray's
/// files are written with the same two figures (max_trace_level, adc_bailout).
constexpr int deepest = 32;
constexpr float least_share = 1e-6F;
/// Just below 1: draws the last lobe of a Bsdf.
constexpr float last_lobe = 0x1.fffffep-1F;

/// A way that is still to be followed.
struct Way {
    Ray ray;
    const Medium* medium;
    Rgb throughput{1};
    int depth = 0;
    bool straight = true;  ///< nothing has bent it since the eye, so it shows the backdrop
};

/// What Bsdf::sample leaves for the light that goes on: its share, and its direction.
struct Onward {
    Vec3 wi;  ///< local
    Rgb share;
};

/// The delta lobe to the other side, with the whole of its share.
Onward transmitted(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo) noexcept {
    if (!any(bsdf.lobes() & Lobe::transmitted)) return {};
    const BsdfSample s = bsdf.sample(wo, last_lobe, {0.5F, 0.5F}, Lobe::specular | Lobe::transmitted);
    if (!s.is_delta() || !any(s.lobe & Lobe::transmitted) || is_black(s.weight)) return {};
    Rgb share = bsdf.albedo(wo).transmitted;
    // Radiance that enters a denser medium is squeezed into a narrower cone; what is not bent stays as it is.
    if (!(s.wi == -wo)) {
        const float eta_o = (wo.z > 0 ? point.front : point.back)->ior;
        const float eta_i = (wo.z > 0 ? point.back : point.front)->ior;
        share *= eta_o * eta_o / (eta_i * eta_i);
    }
    return {s.wi, share};
}

/// The delta lobe to the same side.
Onward reflected(const Bsdf& bsdf, Vec3 wo) noexcept {
    const BsdfSample s = bsdf.sample(wo, 0.5F, {0.5F, 0.5F}, Lobe::specular);
    if (!s.is_delta()) return {};
    return {s.wi, s.weight};
}

/// Everything that comes along one ray of the eye. Depth first, so that as many ways wait as there are levels.
class Tree {
public:
    Tree(const World& world, const NextEvent& next_event, Sampler& sampler)
        : world_(world), next_event_(next_event), sampler_(sampler) {}

    LightParts follow(const EyeRay& eye) noexcept {
        // Most rays end at the first surface, without a way in the list.
        const Way first{eye.ray, eye.medium};
        step(first);
        while (waiting_ > 0) {
            const Way way = *std::launder(reinterpret_cast<const Way*>(memory_ + --waiting_ * sizeof(Way)));
            step(way);
        }
        return parts_;
    }

private:
    void push(const Way& way) noexcept {
        if (max_component(way.throughput) >= least_share && way.depth <= deepest)
            new (memory_ + waiting_++ * sizeof(Way)) Way(way);
    }

    void add(int depth, Rgb LightParts::*part, Rgb L) noexcept { (depth == 0 ? parts_.*part : parts_.specular) += L; }

    [[nodiscard]] Rgb sky(const Way& way) const noexcept {
        const Vec3 d(way.ray.d);
        Rgb sum;
        for (const auto& light : world_.lights()) sum += way.straight ? light->backdrop(d) : light->escaped(d);
        return sum;
    }

    /// Not of a way that is still in the list: those that go on take its place.
    void step(const Way& way) noexcept {
        const Hit hit = world_.intersect(way.ray);
        Rgb arriving = way.throughput;
        // Infinity times no absorption would be NaN.
        if (!is_black(way.medium->absorption))
            arriving *= exp(way.medium->absorption * -static_cast<float>(std::min(hit.t, 1e30)));
        if (!hit.found()) return add(way.depth, &LightParts::emission, arriving * sky(way));
        const SurfacePoint point = world_.surface(way.ray, hit);
        const Vec3 wo(-way.ray.d);
        add(way.depth, &LightParts::emission, arriving * world_.emitted(point, wo));
        if (point.lamp >= 0) return;
        BsdfMemory memory;
        const Bsdf& bsdf = *world_.bsdf(point, memory);
        if (!bsdf.is_delta()) add(way.depth, &LightParts::direct, arriving * direct(point, bsdf, wo));
        if (!any(bsdf.lobes() & Lobe::specular)) return;
        const Vec3 wo_local = point.frame.to_local(wo);
        go_on(way, arriving, point, transmitted(point, bsdf, wo_local), wo_local);
        go_on(way, arriving, point, reflected(bsdf, wo_local), wo_local);
    }

    void go_on(const Way& from, Rgb arriving, const SurfacePoint& point, const Onward& onward, Vec3 wo_local) noexcept {
        if (is_black(onward.share)) return;
        ++ray_counts.specular;
        Way way = from;
        const Vec3 wi = point.frame.to_world(onward.wi);
        way.ray = point.ray(wi);
        // A filter does not bend the ray at all: rounding must not either.
        const bool unbent = onward.wi == -wo_local;
        if (unbent) way.ray.d = from.ray.d;
        way.straight = from.straight && unbent;
        way.medium = dot(point.ng, wi) > 0 ? point.front : point.back;
        way.throughput = arriving * onward.share;
        ++way.depth;
        push(way);
    }

    [[nodiscard]] Rgb direct(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo) const noexcept {
        const LightQuery query{point, bsdf, point.frame.to_local(wo)};
        const auto lights = world_.lights();
        Rgb sum;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const int grid = lights[i]->grid();
            if (grid == 0) {
                sum += next_event_.sampled_light(query, i, 1, next_event_.is_point(i) ? Vec2{} : sampler_.next2());
                continue;
            }
            const float side = static_cast<float>(grid);
            Rgb points;
            for (int y = 0; y < grid; ++y)
                for (int x = 0; x < grid; ++x)
                    points += next_event_.sampled_light(
                        query, i, 1, {(static_cast<float>(x) + 0.5F) / side, (static_cast<float>(y) + 0.5F) / side});
            sum += points * (1 / (side * side));
        }
        return sum;
    }

    const World& world_;
    const NextEvent& next_event_;
    Sampler& sampler_;
    LightParts parts_;
    /// Room for the ways that wait: not an array of them, which would be cleared for every ray of the eye.
    alignas(Way) std::byte memory_[(deepest + 2) * sizeof(Way)];
    std::size_t waiting_ = 0;
};

class WhittedLighting final : public LightingModule {
public:
    void prepare(const World& world, const Eye*, Progress&) override {
        next_event_ = std::make_unique<NextEvent>(world);
    }
    [[nodiscard]] std::optional<LightParts> incoming(const World& world, const EyeRay& eye,
                                                     Sampler& sampler) const noexcept override {
        return Tree(world, *next_event_, sampler).follow(eye);
    }

private:
    std::unique_ptr<NextEvent> next_event_;
};

std::unique_ptr<LightingModule> make(const Params&, std::uint32_t) { return std::make_unique<WhittedLighting>(); }

}  // namespace

const LightingKind whitted_lighting{
    "whitted", "as direct, following every way of mirrors and glass: no noise", {}, make};

}  // namespace cardioid

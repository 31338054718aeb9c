#pragma once
#include <vector>

#include "rt_core/api/lighting.hpp"

namespace cardioid {

/// A point that asks for light straight from the lights.
struct LightQuery {
    const SurfacePoint& point;
    const Bsdf& bsdf;
    Vec3 wo;                                  ///< local
    Lobe tried = Lobe::none;                  ///< a direction of these lobes is tried too, so densities are weighed
    const LightingModule* shadows = nullptr;  ///< whose shadow photons may spare shadow rays
};

/// Next-event estimation: asks lights for directions and traces what arrives. Where a direction of the Bsdf is tried as
/// well, the two are weighed by the power heuristic (Veach 1997, section 9.2). Read-only once made.
class NextEvent {
public:
    /// Up to so many lights direct() asks each time; of more, it draws so many.
    static constexpr std::size_t most_lights = 16;

    /// The world's lights must be prepared; it must outlive this.
    explicit NextEvent(const World& world);

    /// All light that arrives straight from the lights and leaves along wo (world) by the non-delta lobes.
    [[nodiscard]] Rgb direct(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Sampler& sampler,
                             const LightingModule* shadows) const noexcept;
    /// The same of one light, by a direction of that light; `draws`: how often a point asks for it, on average.
    [[nodiscard]] Rgb sampled_light(const LightQuery& query, std::size_t light, float draws, Vec2 u) const noexcept;
    /// Whether a ray drawn from a Bsdf may find the light; else sampled_light() tells all of it.
    [[nodiscard]] bool found_by_rays(std::size_t light) const noexcept { return found_by_rays_[light]; }
    /// Whether it stands in one direction from wherever it is seen, whatever numbers it is given.
    [[nodiscard]] bool is_point(std::size_t light) const noexcept { return is_point_[light]; }

private:
    /// How often a call of direct() draws from the light, on average.
    [[nodiscard]] float draws(std::size_t light) const noexcept;
    /// Calls use(point, share) for every light the ray meets, and use(null, share) where it leaves the scene.
    template <class Use>
    void look(const Ray& ray, Use&& use) const noexcept;
    [[nodiscard]] Rgb arriving(const LightQuery& query, std::size_t light, const LightSample& sample) const noexcept;
    [[nodiscard]] Rgb sampled_bsdf(const LightQuery& query, Sampler& sampler) const noexcept;

    const World& world_;
    std::vector<bool> found_by_rays_, is_point_;
    std::vector<float> light_cdf_;  ///< for the choice among many lights; empty while all are asked each time
    bool wide_light_ = false;       ///< some light is so wide that diffuse surfaces too look for it
    bool filters_ = false;          ///< some material lets shadow rays through
};

/// What light from a lamp at `distance` is multiplied by at a point whose side towards it is filled with `medium`
/// (may be null): absorption on the way and the Bsdf's own attenuation. Light from infinity is not attenuated.
[[nodiscard]] Rgb share_over(const Bsdf& bsdf, const Medium* medium, double distance) noexcept;

}  // namespace cardioid

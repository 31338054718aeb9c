#pragma once
#include "photon/map/photon_map.hpp"

namespace cardioid::photon {

/// Light that met no diffuse surface, on surfaces with glossy lobes: what of it photons know well comes from the
/// caustic map, the rest from rays (breadth.hpp, path_class.hpp).
class GlossyCaustics {
public:
    /// `first` is how the map is read where it is asked for, `beyond` at surfaces that rays meet. World and map must
    /// outlive it.
    GlossyCaustics(const World& world, const PhotonMap& map, const LookupRule& first, const LookupRule& beyond);

    /// Radiance that leaves `point` towards wo (world) by all of its non-delta lobes: one ray of the glossy ones.
    [[nodiscard]] Rgb radiance(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Sampler& sampler) const noexcept;

private:
    struct Walk;
    [[nodiscard]] Rgb looked_up(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, bool first) const noexcept;
    [[nodiscard]] Rgb looked_up(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Vec3 n,
                                bool first) const noexcept;
    [[nodiscard]] Rgb followed(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Sampler& sampler) const noexcept;
    [[nodiscard]] bool step(Walk& walk, Sampler& sampler) const noexcept;
    [[nodiscard]] bool bounce(Walk& walk, const SurfacePoint& point, const Bsdf& bsdf, Lobe lobes, float share,
                              Sampler& sampler) const noexcept;
    [[nodiscard]] Rgb lamp(const Walk& walk, const SurfacePoint& point) const noexcept;
    [[nodiscard]] Rgb far_lamps(const Walk& walk) const noexcept;

    const World& world_;
    const PhotonMap& map_;
    LookupRule first_, beyond_;
    float least_breadth_;
};

}  // namespace cardioid::photon

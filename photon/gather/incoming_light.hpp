#pragma once
#include "photon/gather/diffuse_lobe.hpp"
#include "photon/gather/radiance_map.hpp"
#include "photon/map/photon_map.hpp"
#include "rt_core/api/world.hpp"

namespace cardioid::photon {

/// Light that has met a diffuse surface: what a ray of a final gather brings. Where the ray meets a diffuse lobe all
/// light that falls there is looked up; mirrors, glass and glossy lobes are followed, at broad ones with a look at what
/// lamps and the caustic map send; and light met at its source is left out: World::direct and the caustic map have it
/// (path_class.hpp).
class IncomingLight {
public:
    struct Parts {
        const RadianceMap* radiance = nullptr;  ///< where rays end; null: in `map`
        const PhotonMap* map = nullptr;  ///< of all photons, for rays without radiance photons (the report's way)
        LookupRule lookup;
        const PhotonMap* caustics = nullptr;  ///< null: none
        LookupRule caustic_lookup;
        /// Places nearer than this many radii of the disc that made a radiance photon are not read from it, for it
        /// is too coarse there: direct light is sampled and one more ray sent (Jensen 1996). It keeps corners right.
        float near = 1.5F;
        /// The place where a ray ends first is never looked up, however far.
        bool always_near = false;
        /// Light that broad lobes turn back is looked for where rays meet them; else photons bring it.
        bool broad_apart = true;
    };
    struct Found {
        Rgb L;                                                      ///< radiance [W/(sr unit^2)]
        double distance = std::numeric_limits<double>::infinity();  ///< of what the ray met first
    };

    /// World and maps must outlive it.
    IncomingLight(const World& world, const Parts& parts) : world_(world), parts_(parts) {}

    /// Light that comes to `point` along wi (world, unit, away from it).
    [[nodiscard]] Found along(const SurfacePoint& point, Vec3 wi, Sampler& sampler) const noexcept;
    /// Radiance that leaves `point` towards wo (world) by the lobes asked for, none of them a delta: one ray of them.
    [[nodiscard]] Rgb scattered(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Lobe which,
                                Sampler& sampler) const noexcept;
    /// Irradiance on the side of the shading normal n by so many rays, as the diffuse lobe of `bsdf` takes it.
    [[nodiscard]] Rgb irradiance(const SurfacePoint& point, const Bsdf& bsdf, Vec3 n, int rays,
                                 Sampler& sampler) const noexcept;

private:
    struct Walk;
    [[nodiscard]] Rgb follow(const SurfacePoint& point, Vec3 wi, Walk walk, Sampler& sampler,
                             double& first) const noexcept;
    [[nodiscard]] static Lobe way_on(const Bsdf& bsdf, const SurfacePoint& point, const Walk& walk, Rgb& throughput,
                                     Sampler& sampler) noexcept;
    [[nodiscard]] static bool worth_following(const Bsdf& bsdf, Vec3 wo, Rgb& throughput, Sampler& sampler) noexcept;
    [[nodiscard]] Rgb diffuse(const SurfacePoint& point, const Bsdf& bsdf, const Walk& walk,
                              Sampler& sampler) const noexcept;
    [[nodiscard]] Rgb broad(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Sampler& sampler) const noexcept;
    [[nodiscard]] Rgb diffuse_nearby(const SurfacePoint& point, const DiffuseLobe& lobe, const Walk& walk,
                                     Sampler& sampler) const noexcept;

    const World& world_;
    Parts parts_;
};

}  // namespace cardioid::photon

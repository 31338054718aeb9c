#pragma once
#include <optional>

#include "photon/gather/incoming_light.hpp"
#include "photon/lighting/tuning.hpp"
#include "rt_core/api/eye.hpp"
#include "rt_core/api/lighting.hpp"

namespace cardioid::photon {

/// What of the lookups a plan has found, as it is saved.
struct LookupSizes {
    std::uint32_t k = 50, caustic_k = 50;
    float radius = 0, caustic_radius = 0;  ///< scene units, above 0
};

/// What is known of a scene's light before anything is drawn.
struct LightMaps {
    LookupSizes sizes;
    std::optional<PhotonMap> global;  ///< where lookups read it, or it was asked for
    LookupRule global_lookup;
    std::optional<PhotonMap> caustics;
    LookupRule caustic_lookup;
    RadianceMap radiance;     ///< for the rays of gathers
    RadianceMap precomputed;  ///< the report's cache points
    std::vector<Statistic> statistics;
};

/// Sets how the maps are read.
void set_lookups(const PhotonOptions& options, const LookupSizes& sizes, LightMaps& maps);

/// The same rule for rays of gathers, which average its noise: few photons, and nothing done about edges.
[[nodiscard]] LookupRule quick(LookupRule rule);

/// Shoots the photons of a plan and makes what `options.indirect` reads. Throws Error. Warns of what is wrong with the
/// scene; stops early when interrupted, the maps are then of no use.
/// `eye` null: there is no picture.
[[nodiscard]] LightMaps make_light_maps(const World& world, const Eye* eye, const PhotonOptions& options,
                                        const Plan& plan, const Tuning& tuning, std::uint32_t seed, Progress& progress);

/// Rays of a gather that end in these maps; they must outlive it. `always_near`: IncomingLight::Parts.
[[nodiscard]] IncomingLight make_incoming(const World& world, const PhotonOptions& options, const LightMaps& maps,
                                          bool always_near);

}  // namespace cardioid::photon

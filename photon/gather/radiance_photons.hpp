#pragma once
#include "photon/gather/radiance_map.hpp"
#include "photon/map/photon_map.hpp"
#include "rt_core/api/progress.hpp"

namespace cardioid::photon {

/// How radiance photons are made.
struct RadianceRule {
    std::uint32_t seed = 0;
    float share = 1;                ///< witnesses for each photon of the map
    std::uint32_t light_rays = 16;  ///< calls of World::direct a place; light straight from lamps is not looked up
    int gather_rays = 16;           ///< of each place, once all are known from the map; 0: none
    LookupRule lookup;              ///< of other light
    const PhotonMap* caustics = nullptr;  ///< where caustics are looked up if not in that map
    LookupRule caustic_lookup;
    bool broad_apart = true;  ///< IncomingLight::Parts
};

/// Where radiance photons shall be; all positions relative to one origin.
struct RadiancePlaces {
    std::vector<Photon> places;
    /// Photons shot independently of the map, that tell how many of its photons a lookup may expect.
    UntouchedVector<Photon> witnesses;
    Vec3d origin;
};

/// The irradiance of all light at the places, by `map`, which has no photons straight from lamps, and then by a small
/// gather over what the map told: discs of photons are far too wide where light is dim and close to what is bright.
/// Places and map must be independent: estimates at a map's own photons are too bright by the photon itself, and
/// without it too dark, for photons that stand alone are the nearest to more places. What the map tells is left out
/// where witnesses stand so far apart that a lookup would be of less than some 16 photons. Stops early when
/// interrupted.
[[nodiscard]] std::vector<RadiancePhoton> make_radiance_photons(const World& world, const RadiancePlaces& at,
                                                                const PhotonMap& map, const RadianceRule& rule,
                                                                Progress& progress);

}  // namespace cardioid::photon

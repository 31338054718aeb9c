#pragma once
#include <vector>

#include "photon/emission/shoot.hpp"
#include "photon/map/photon_map.hpp"

namespace cardioid::photon {

/// A place where irradiance is known beforehand: at every n-th photon (Christensen 1999; ARL-TR-3608, note [6]).
struct RadiancePhoton {
    Vec3 p;                ///< relative to the origin of its map, scene units
    std::uint32_t n;       ///< encode_direction: geometric normal on the lit side
    std::uint32_t region;  ///< FaceId::region
    Rgb E;                 ///< W/unit^2
    float blur;            ///< radius of the disc that it was estimated over, scene units
    float reach;           ///< how far off it may be read: what lies beyond is another room for all it knows
};

struct RadiancePayload {
    Rgb E;
    float blur, reach;
};
inline RadiancePayload payload_of(const RadiancePhoton& photon) { return {photon.E, photon.blur, photon.reach}; }

/// How radiance photons are made.
struct RadianceRule {
    std::uint32_t seed = 0;
    std::uint32_t every = 4;        ///< n
    float share = 1;                ///< places for each photon of the map: tells how many photons a lookup may expect
    std::uint32_t light_rays = 16;  ///< calls of World::direct a photon; light straight from lamps is not looked up
    LookupRule lookup;              ///< of other light
    const PhotonMap* caustics = nullptr;  ///< where caustics are looked up if not in that map
    LookupRule caustic_lookup;
};

/// Places at every n-th photon with the irradiance of all light there, by `map`, which has no photons straight from
/// lamps. `places` and `map` must be shot independently: estimates at a map's own photons are too bright by the photon
/// itself, and without it too dark, for photons that stand alone are the nearest to more places. Left out are those
/// where places stand so far apart that a lookup would be of less than some 16 photons. Stops early when interrupted.
[[nodiscard]] std::vector<RadiancePhoton> make_radiance_photons(const World& world, const Shot& places,
                                                                const PhotonMap& map, const RadianceRule& rule,
                                                                Progress& progress);

/// Irradiance known at many places: what the rays of a final gather read where they end. Read-only once made; any
/// thread may look up.
class RadianceMap {
public:
    RadianceMap() = default;
    RadianceMap(std::vector<RadiancePhoton> photons, Vec3d origin) : tree_(std::move(photons)), origin_(origin) {}

    /// The nearest place on the same side of the same solid, null where there is none or it does not reach so far.
    [[nodiscard]] const RadiancePayload* nearest(const SurfacePoint& point, Vec3 ng) const noexcept;
    /// The mean of the nearest places, as many as that, whose normals are within 60 degrees (ARL-TR-3608, section 7),
    /// black those that do not reach so far;
    /// `edges`: divided by the share of places near by that passed that test (note [8]).
    [[nodiscard]] Rgb mean(const SurfacePoint& point, Vec3 ng, std::uint32_t nearest, bool edges) const noexcept;

    /// Whether there is a place within `radius` of p.
    [[nodiscard]] bool near(Vec3d p, float radius) const noexcept;

    [[nodiscard]] std::uint32_t size() const noexcept { return tree_.size(); }
    [[nodiscard]] Vec3d origin() const noexcept { return origin_; }
    /// As they were given, in the order of the tree; a map made of them is the same.
    [[nodiscard]] std::vector<RadiancePhoton> photons() const;
    [[nodiscard]] std::size_t memory_bytes() const noexcept { return tree_.memory_bytes(); }

private:
    PointTree<RadiancePhoton> tree_;
    Vec3d origin_;
};

}  // namespace cardioid::photon

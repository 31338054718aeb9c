#pragma once
#include <unordered_map>
#include <vector>

#include "photon/map/photon.hpp"
#include "photon/map/tree/point_tree.hpp"
#include "rt_core/api/surface.hpp"

namespace cardioid::photon {

/// A place where irradiance is known beforehand (Christensen 1999; ARL-TR-3608, note [6]).
struct RadiancePhoton {
    Vec3 p;                ///< relative to the origin of its map, scene units
    std::uint32_t n;       ///< encode_direction: geometric normal on the lit side
    std::uint32_t region;  ///< FaceId::region
    Rgb E;                 ///< W/unit^2
    float blur;            ///< it tells nothing of what changes within that distance, scene units
    float reach;           ///< how far off it may be read: what lies beyond is another room for all it knows
};

struct RadiancePayload {
    Rgb E;
    float blur, reach;
};
inline RadiancePayload payload_of(const RadiancePhoton& photon) { return {photon.E, photon.blur, photon.reach}; }

/// Places on the surface that p is on, with normals within 30 degrees.
[[nodiscard]] inline PointQuery same_surface(Vec3 p, Vec3 n, std::uint32_t region) noexcept {
    return {.p = p, .n = n, .least_cos = 0.866F, .steepness = 0.25F, .region = region};
}

/// Irradiance known at many places: what the rays of a final gather read where they end. Read-only once made; any
/// thread may look up.
class RadianceMap {
public:
    RadianceMap() = default;
    RadianceMap(const std::vector<RadiancePhoton>& photons, Vec3d origin);

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
    std::unordered_map<std::uint32_t, float> reach_;  ///< of the places of each region, the farthest
};

}  // namespace cardioid::photon

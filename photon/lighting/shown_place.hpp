#pragma once
#include <optional>

#include "photon/lighting/light_maps.hpp"

namespace cardioid::photon {

/// What one lookup and one final gather find, at a place that the picture sees: figures 2 and 5 of ARL-TR-3608.
class ShownPlace {
public:
    /// At the first place seen through the pixel of the options, else through the middle of what is drawn.
    ShownPlace(const World& world, const Eye& eye, const PhotonOptions& options, const LightMaps& maps,
               const Hemisphere& hemisphere, std::uint32_t seed);

    /// The lookup's disc, with the photons that count in white (as bright as their weight) and those that do not in
    /// red; photons elsewhere in grey. `dot`: radius of a photon as it is drawn, scene units.
    [[nodiscard]] Rgb lookup(const PhotonMap* map, const SurfacePoint& point, float dot) const noexcept;
    /// Where the rays of the gather end, one colour a ring, and the place itself.
    [[nodiscard]] Rgb gather(const SurfacePoint& point, float dot) const noexcept;

private:
    struct RayEnd {
        Vec3d p;
        int ring;
    };
    void look_up(const World& world, const PhotonMap& map, const LookupRule& rule);
    void shoot_rays(const World& world, const Hemisphere& hemisphere, std::uint32_t seed);

    std::optional<SurfacePoint> place_;  ///< nothing where nothing scatters there
    Vec3 ng_, n_;
    float radius_ = 0;
    std::vector<std::pair<std::uint32_t, float>> counted_;  ///< photons of the lookup by index, share of most weight
    std::vector<RayEnd> ends_;
};

}  // namespace cardioid::photon

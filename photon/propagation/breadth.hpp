#pragma once
#include "photon/map/photon.hpp"
#include "rt_core/api/world.hpp"

namespace cardioid::photon {

/// Caustic light on a glossy lobe is found in two ways. Photons know it well where it comes from few directions: of
/// those that fall within a disc, all are of use. Where it comes from many, few of them lie within a narrow lobe, and
/// each makes a blob; but there a ray drawn from the lobe meets the lamp often. A ray meets light of solid angle
/// `breadth` with the chance q = pdf breadth, if pdf is the lobe's density towards it. Of each path the rays have the
/// share q^2 / (q^2 + c^2), photons the rest (path_class.hpp). Both know pdf and breadth, so that nothing is counted
/// twice; neither a ray nor a photon can be brighter than about the lamp itself (Veach 1997, section 9.2.4, has the
/// power of two).
[[nodiscard]] float traced_share(float pdf, Breadth breadth) noexcept;

/// Solid angle [sr] as the photons keep it, to an eighth of a power of two; below 4 pi 2^-32 none at all.
[[nodiscard]] Breadth encode_breadth(float solid_angle) noexcept;
[[nodiscard]] float decode_breadth(Breadth breadth) noexcept;

/// Where a path from a lamp first meets a mirror or glass.
struct FirstMirror {
    Vec3d p;
    Vec3 to_lamp;         ///< unit
    double distance = 0;  ///< from the lamp, scene units; infinite for sky and sun
};
/// Under which solid angle the lamp is seen after a way of `length` from it by mirrors and glass: as the lamp's own
/// density of directions has it at the first of them, and as flat mirrors would have it from there on.
[[nodiscard]] Breadth lamp_breadth(const Light& light, const FirstMirror& first, double length) noexcept;
/// The same for a photon, which knows whether it left a face (Ray::from) and no more of whether rays can meet its lamp.
[[nodiscard]] Breadth photon_breadth(const Light& light, bool left_face, FirstMirror first, double length) noexcept;

/// Over which solid angle light is scattered to wo (local) by the glossy lobes of a Bsdf, from its peak; not less than
/// `least` [sr].
[[nodiscard]] Breadth lobe_breadth(const Bsdf& bsdf, Vec3 wo, float least) noexcept;

/// Whether the glossy lobes of a Bsdf send light to wo (local) from so many directions that they are like diffuse ones:
/// photons that have met them would be spread thinly over all that is around, and rays that meet them ask what light
/// falls there (path_class.hpp).
[[nodiscard]] bool is_broad(const Bsdf& bsdf, Vec3 wo) noexcept;

/// The least solid angle [sr] of any lamp of the scene, from as far as half its size; 0 where there are points, spots
/// or parallel light. Light that a glossy surface passes on is no narrower than that.
[[nodiscard]] float least_breadth(const World& world) noexcept;

}  // namespace cardioid::photon

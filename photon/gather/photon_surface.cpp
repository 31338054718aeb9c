#include "photon/gather/photon_surface.hpp"

namespace cardioid::photon {

namespace {

/// Floats place a photon to less than this share of the scene's size; from so far before it the surface is found again.
constexpr double rounding = 0x1p-18;

}  // namespace

std::optional<SurfacePoint> surface_under(const World& world, const Photon& photon, Vec3d origin) {
    const double lift = rounding * world.bounds().diagonal();
    const Vec3d wi(decode_direction(photon.wi));
    const Ray ray{origin + Vec3d(photon.p) + wi * lift, -wi, 2 * lift, {}, {}};
    const Hit hit = world.intersect(ray);
    if (!hit.found() || hit.id.region != photon.region) return std::nullopt;
    return world.surface(ray, hit);
}

}  // namespace cardioid::photon

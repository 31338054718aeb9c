#include "photon/map/probe_area.hpp"

#include <numbers>

namespace cardioid::photon {

namespace {

/// How high above the surface the probes start, in radii: low enough to be stopped by what stands on it.
constexpr double lift = 0.25;
/// Photons are known to float precision, so this share of the way before and behind them is left open.
constexpr double short_of = 1 - 0x1p-12, beyond = 1 + 0x1p-12;
constexpr double golden_turn = std::numbers::pi * (3 - 2.2360679774997896);  ///< 2 pi / golden ratio^2

}  // namespace

SurfaceProbe::SurfaceProbe(const World& world, const ProbeDisc& disc) noexcept
    : world_(world),
      disc_(disc),
      frame_(disc.n),
      turn_(2 * std::numbers::pi * double{unit_float(static_cast<std::uint32_t>(mix64(disc.turn)))}) {
    const Vec3d n(disc.n);
    const double height = lift * double{disc.radius};
    const Hit above = world.intersect(disc.point.ray(disc.n, 2 * height));
    const bool covered = above.found() && dot(above.ng, disc.n) < 0;  // else the way out of the point's own surface
    eye_ = disc.point.p + n * (covered ? std::min(height, above.t / 2) : height);
}

Vec3d SurfaceProbe::on_plane(double r, double phi) const noexcept {
    const double x = r * double{disc_.radius} * std::cos(phi), y = r * double{disc_.radius} * std::sin(phi);
    return disc_.point.p + Vec3d(frame_.s) * x + Vec3d(frame_.t) * y;
}

/// A sunflower: places in equal shares of the area, no two in the same direction (Vogel 1979).
Vec3d SurfaceProbe::place(std::uint32_t i) const noexcept {
    return on_plane(std::sqrt((i + 0.5) / places), turn_ + i * golden_turn);
}

bool SurfaceProbe::rim_reached() const noexcept {
    constexpr int around = 12;
    constexpr double rim = 0.95;
    for (int i = 0; i < around; ++i)
        if (look(on_plane(rim, turn_ + i * (2 * std::numbers::pi / around))) != Sight::reached) return false;
    return true;
}

bool SurfaceProbe::same_surface(const Ray& ray, const Hit& hit) const noexcept {
    const Vec3d met = ray.o + ray.d * hit.t - disc_.point.p, n(disc_.n);
    const double height = dot(met, n), across = length(met - n * height);
    const Vec3d ng = dot(Vec3d(hit.ng), ray.d) < 0 ? Vec3d(hit.ng) : -Vec3d(hit.ng);
    const Vec3d sine = cross(ng, n);
    const double bend = std::sqrt((double{most_bend2} * dot(sine, sine) + double{bend_slack2}) * dot(met, met));
    return dot(ng, n) >= double{disc_.least_cos} &&
           std::abs(height) <= std::max(std::min(double{disc_.steepness} * across, bend), double{disc_.slack}) &&
           (!disc_.same_region || hit.id.region == disc_.point.id.region);
}

SurfaceProbe::Sight SurfaceProbe::look(Vec3d p) const noexcept {
    const Vec3d way = p - eye_, n(disc_.n);
    const double distance = length(way), height = dot(eye_ - disc_.point.p, n);
    const Ray ray{eye_, way / distance, distance * beyond, {}, {}};
    const Hit hit = world_.intersect(ray);
    if (hit.found() && same_surface(ray, hit)) return Sight::reached;
    if (hit.found() && hit.t < distance * short_of) return Sight::hidden;
    // Where the surface bends away the ray passes over it; from above it is still found.
    const double depth = double{disc_.steepness} * length(p - disc_.point.p) + double{disc_.slack};
    const Ray down{p + n * height, -n, height + depth, {}, {}};
    const Hit below = world_.intersect(down);
    return below.found() && same_surface(down, below) ? Sight::reached : Sight::missing;
}

SurfaceProbe::Sight SurfaceProbe::reaches(Vec3d p) noexcept {
    const Sight sight = look(p);
    something_hides_ |= sight == Sight::hidden;
    return sight;
}

bool SurfaceProbe::sees(Vec3d p) const noexcept {
    const Vec3d way = p - eye_;
    const double distance = length(way), drop = -dot(way, Vec3d(disc_.n));
    // Less what the place may be wrong by across the surface.
    const double free = distance * (short_of - double{disc_.slack} / drop);
    return !(free > 0) || !world_.occluded({eye_, way / distance, free, {}, {}});
}

}  // namespace cardioid::photon

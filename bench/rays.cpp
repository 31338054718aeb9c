#include "bench/rays.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace cardioid::bench {
namespace {

class Random {
public:
    double operator()() { return static_cast<double>(engine_()) * 0x1p-32; }
    Vec3d direction() {
        const double z = 2 * (*this)() - 1, phi = 2 * std::numbers::pi * (*this)(), rho = std::sqrt(1 - z * z);
        return {rho * std::cos(phi), rho * std::sin(phi), z};
    }
    Vec3d point(const Box3d& in) {
        const double x = (*this)(), y = (*this)(), z = (*this)();
        const Vec3d s = in.size();
        return in.lo + Vec3d{x * s.x, y * s.y, z * s.z};
    }

private:
    std::mt19937 engine_{7};
};

Ray free_ray(const Vec3d& o, const Vec3d& d) {
    Ray ray;
    ray.o = o, ray.d = normalize(d);
    return ray;
}

}  // namespace

Rays primary_rays(const View& view, std::uint32_t width) {
    const Vec3d forward = normalize(view.target - view.eye);
    const Vec3d right = normalize(cross(forward, std::abs(forward.z) < 0.99 ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0}));
    const Vec3d up = cross(right, forward);
    const double half = std::tan(view.fov_deg * std::numbers::pi / 360);
    Rays rays;
    for (std::uint32_t y = 0; y < width; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const double sx = half * ((2 * x + 1.0) / width - 1), sy = half * (1 - (2 * y + 1.0) / width);
            rays.push_back(free_ray(view.eye, forward + right * sx + up * sy));
        }
    return rays;
}

Rays random_rays(const Box3d& bounds, std::uint32_t count) {
    Random random;
    Rays rays;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3d o = bounds.centre() + random.direction() * bounds.diagonal();
        rays.push_back(free_ray(o, random.point(bounds) - o));
    }
    return rays;
}

Rays inside_rays(const Box3d& bounds, std::uint32_t count) {
    Random random;
    Rays rays;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3d o = random.point(bounds);
        rays.push_back(free_ray(o, random.direction()));
    }
    return rays;
}

Rays bounced_rays(const Tracer& tracer, const Rays& rays, std::uint32_t count) {
    Random random;
    Rays bounced;
    for (const Ray& ray : rays) {
        if (bounced.size() == count) break;
        const Hit hit = tracer.intersect(ray);
        if (!hit.found()) continue;
        const Vec3d n = dot(Vec3d(hit.ng), ray.d) < 0 ? Vec3d(hit.ng) : -Vec3d(hit.ng);
        // A point of the unit sphere on the normal's tip is distributed as the cosine.
        bounced.push_back(free_ray(ray.o + ray.d * hit.t, n + random.direction() * (1 - 1e-9)));
        bounced.back().from = hit.id, bounced.back().from_ng = hit.ng;
    }
    return bounced;
}

}  // namespace cardioid::bench

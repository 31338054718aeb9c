#include "tests/accuracy/light_ray.hpp"

#include <numbers>

namespace cardioid::test {

namespace {

/// A number that draws the other way than reflection wherever there is one.
constexpr float not_reflected = 0x1.fffffep-1F;

}  // namespace

LightRay follow(const World& world, Vec3d o, Vec3d d, const std::vector<Turn>& turns) {
    LightRay light{o, normalize(d)};
    Ray ray{o, normalize(d), Box3d::infinity, {}, {}};
    for (const Turn turn : turns) {
        const Hit hit = world.intersect(ray);
        light.gone = !hit.found();
        if (light.gone) return light;
        const SurfacePoint point = world.surface(ray, hit);
        BsdfMemory memory;
        const Bsdf* bsdf = world.bsdf(point, memory);
        const Vec3 wo = point.frame.to_local(Vec3(-ray.d));
        const bool reflects = turn == Turn::reflect;
        const BsdfSample drawn = bsdf->sample(wo, reflects ? 0 : not_reflected, {0.5F, 0.5F},
                                              reflects ? Lobe::specular : Lobe::specular | Lobe::transmitted);
        light.gone = !any(drawn.lobe) || any(drawn.lobe & Lobe::transmitted) == reflects;
        if (light.gone) return light;
        const Albedo albedo = bsdf->albedo(wo);
        light.share *= static_cast<double>(reflects ? albedo.specular.g : albedo.transmitted.g);
        light.last_cosine = std::abs(static_cast<double>(wo.z));
        ray = point.ray(point.frame.to_world(drawn.wi));
        light.o = ray.o, light.d = ray.d;
    }
    return light;
}

double angle_between(Vec3d a, Vec3d b) { return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi; }

}  // namespace cardioid::test

#include "photon/propagation/breadth.hpp"

#include <algorithm>
#include <cmath>

namespace cardioid::photon {

namespace {

/// Steps of a code for a power of two, and the code of the whole sphere. 0 is no solid angle at all.
constexpr float steps = 8, last = 255;
constexpr float sphere = 4 * pi;
/// The chance to meet a lamp from which on rays have more than half of its light.
constexpr float even_chance = 0.25F;
/// Solid angle [sr] from which on a lobe is broad: that of GGX with alpha .15, and of (cos)^n with n = 20.
constexpr float broad = 0.3F;

Vec3 mirrored(Vec3 wo) noexcept { return {-wo.x, -wo.y, wo.z}; }

}  // namespace

float traced_share(float pdf, Breadth breadth) noexcept {
    const float q = pdf * decode_breadth(breadth) / even_chance;
    return 1 / (1 + 1 / (q * q));
}

Breadth encode_breadth(float solid_angle) noexcept {
    if (!(solid_angle > 0)) return Breadth::none;
    const float code = last + steps * std::log2(std::min(solid_angle / sphere, 1.0F));
    return static_cast<Breadth>(std::lround(std::max(code, 0.0F)));
}

float decode_breadth(Breadth breadth) noexcept {
    if (breadth == Breadth::none) return 0;
    return sphere * std::exp2((static_cast<float>(breadth) - last) / steps);
}

Breadth lamp_breadth(const Light& light, const FirstMirror& first, double length) noexcept {
    const float pdf = light.pdf(first.p, first.to_lamp);
    if (!(pdf > 0)) return Breadth::none;
    const double nearer = std::isfinite(first.distance) ? first.distance / length : 1;
    return encode_breadth(static_cast<float>(nearer * nearer / double{pdf}));
}

Breadth photon_breadth(const Light& light, bool left_face, FirstMirror first, double length) noexcept {
    if (!left_face) {
        if (is_black(light.escaped(first.to_lamp))) return Breadth::none;
        first.distance = std::numeric_limits<double>::infinity();
    }
    return lamp_breadth(light, first, length);
}

Breadth lobe_breadth(const Bsdf& bsdf, Vec3 wo, float least) noexcept {
    const float peak = bsdf.pdf(wo, mirrored(wo), Lobe::glossy);
    return encode_breadth(peak > 0 ? std::max(1 / peak, least) : sphere);
}

bool is_broad(const Bsdf& bsdf, Vec3 wo) noexcept {
    float peak = bsdf.pdf(wo, mirrored(wo), Lobe::glossy);
    if (any(bsdf.lobes() & Lobe::transmitted))
        peak = std::max(peak, bsdf.pdf(wo, -wo, Lobe::glossy | Lobe::transmitted));
    return peak * broad < 1;
}

float least_breadth(const World& world) noexcept {
    const double size = world.bounds().empty() ? 0 : world.bounds().diagonal() / 2, away = size > 0 ? size : 1;
    float least = sphere;
    for (const auto& light : world.lights()) {
        const LightEmission photon = light->emit({0.5F, 0.5F}, {0.5F, 0.5F});
        if (is_black(photon.flux)) continue;
        const FirstMirror there{photon.ray.o + photon.ray.d * away, Vec3(-photon.ray.d), away};
        const bool left_face = photon.ray.from.region != FaceId::none;
        least = std::min(least, decode_breadth(photon_breadth(*light, left_face, there, away)));
    }
    return least;
}

}  // namespace cardioid::photon

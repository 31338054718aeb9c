#include "photon/propagation/roulette.hpp"

namespace cardioid::photon {

namespace {

constexpr Lobe shiny = Lobe::glossy | Lobe::specular;

/// The chance to go on with `weight`, not yet cut at 1.
float chance(const RouletteRule& rule, Rgb weight, Rgb flux) {
    if (rule.by == Roulette::mean) return (weight.r + weight.g + weight.b) * (1.0F / 3);
    return max_component(weight * flux) / max_component(flux);
}

/// What turns a Bsdf's weight, which is for radiance along wo, into that of flux that came from wo.
float to_flux(const ScatterQuery& q, const BsdfSample& s, bool straight) {
    float factor = 1;
    const SurfacePoint& point = q.point;
    if (any(s.lobe & Lobe::transmitted) && !straight && point.front && point.back) {
        const float eta = q.wo.z > 0 ? point.back->ior / point.front->ior : point.front->ior / point.back->ior;
        factor = eta * eta;
    }
    if (point.frame.n == point.ng) return factor;
    const Vec3 ng = point.frame.to_local(point.ng);
    const float o = dot(q.wo, ng), i = dot(s.wi, ng);
    // Light must not leak through the surface where the two normals disagree about its sides.
    if (o * q.wo.z <= 0 || i * s.wi.z <= 0) return 0;
    return factor * std::abs(q.wo.z * i / (o * s.wi.z));
}

}  // namespace

bool passes_filter(const World& world, const SurfacePoint& point, Vec3 wo, const BsdfSample& s) noexcept {
    if (!any(s.lobe & Lobe::transmitted) || !s.is_delta() || !(s.wi == -wo)) return false;
    const Shader& shader = *world.materials()[point.material].shader;
    return shader.filters() && !is_black(shader.straight_transmittance(point, wo));
}

Scattered scatter(const ScatterQuery& q, Vec2 u, Vec2 u_direction) noexcept {
    Lobe which = q.bsdf.lobes() & q.which;
    if (!any(which & (Lobe::diffuse | shiny))) return {};
    float chosen = 1, u_lobe = u.x;
    if (any(which & Lobe::diffuse) && any(which & shiny)) {
        const Albedo albedo = q.bsdf.albedo(q.wo);
        const float diffuse = chance(q.rule, albedo.diffuse, q.flux);
        const float other = chance(q.rule, albedo.specular + albedo.transmitted, q.flux);
        if (!(diffuse + other > 0)) return {};
        const float share = diffuse / (diffuse + other);
        const bool to_diffuse = u_lobe < share;
        chosen = to_diffuse ? share : 1 - share;
        u_lobe = std::min((to_diffuse ? u_lobe : u_lobe - share) / chosen, 0x1.fffffep-1F);
        which = which & ((to_diffuse ? Lobe::diffuse : shiny) | Lobe::transmitted);
    }
    const BsdfSample s = q.bsdf.sample(q.wo, u_lobe, u_direction, which);
    if (is_black(s.weight)) return {};
    const bool straight = passes_filter(q.world, q.point, q.wo, s);
    const Rgb weight = s.weight * (to_flux(q, s, straight) / chosen);
    const float survival = std::min(1.0F, chance(q.rule, weight, q.flux));
    // A weight that is not a number goes on and is counted by the caller.
    if (u.y >= survival) return {};
    return {s.wi, q.flux * weight * (q.rule.double_count ? chosen : 1 / survival), s.lobe, straight};
}

Rgb pass_medium(const Medium& medium, double length, Rgb flux, float u) noexcept {
    const Rgb left = exp(medium.absorption * -static_cast<float>(length)) * flux;
    const float survival = max_component(left) / max_component(flux);
    return u < survival ? left / survival : Rgb{};
}

}  // namespace cardioid::photon

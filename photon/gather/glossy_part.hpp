#pragma once
#include "rt_core/api/bsdf.hpp"

namespace cardioid::photon {

/// What of a Bsdf's value is not its diffuse lobe as irradiance knows it (Bsdf::diffuse_acceptance) [1/sr]: its glossy
/// lobes, and by how much a diffuse one that depends on wo and wi together is brighter than that.
inline Rgb glossy_value(const Bsdf& bsdf, Vec3 wo, Vec3 wi, Rgb diffuse_albedo) noexcept {
    const Rgb all = bsdf.f(wo, wi);
    if (is_black(diffuse_albedo) || wo.z * wi.z <= 0) return all;
    const float scale = inv_pi * bsdf.diffuse_acceptance(wi);
    const auto rest = [scale](float f, float albedo) { return std::max(f - albedo * scale, 0.0F); };
    return {rest(all.r, diffuse_albedo.r), rest(all.g, diffuse_albedo.g), rest(all.b, diffuse_albedo.b)};
}

/// The glossy lobes of a Bsdf by themselves: asks World::direct what light a surface turns back by these alone.
class GlossyPart final : public Bsdf {
public:
    static constexpr Lobe glossy = Lobe::glossy | Lobe::transmitted;

    /// `whole` must outlive it; wo (local) is where the light goes to.
    GlossyPart(const Bsdf& whole, Vec3 wo) noexcept
        : whole_(whole), diffuse_(any(whole.lobes() & Lobe::diffuse) ? whole.albedo(wo).diffuse : Rgb{}) {}
    [[nodiscard]] Lobe lobes() const noexcept override { return whole_.lobes() & glossy; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override { return glossy_value(whole_, wo, wi, diffuse_); }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override {
        return whole_.pdf(wo, wi, which & glossy);
    }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float u_lobe, Vec2 u, Lobe which) const noexcept override {
        return whole_.sample(wo, u_lobe, u, which & glossy);
    }
    [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept override {
        Albedo albedo = whole_.albedo(wo);
        albedo.diffuse = {};
        return albedo;
    }
    [[nodiscard]] float attenuation(double distance) const noexcept override { return whole_.attenuation(distance); }

private:
    const Bsdf& whole_;
    Rgb diffuse_;
};

}  // namespace cardioid::photon

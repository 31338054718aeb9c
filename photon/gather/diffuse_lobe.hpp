#pragma once
#include "rt_core/api/bsdf.hpp"

namespace cardioid::photon {

/// The diffuse lobe of a Bsdf by itself, with another reflectance: asks World::direct what light a surface turns back
/// by this lobe alone, and with reflectance pi for its irradiance, each direction as the lobe takes it
/// (Bsdf::diffuse_acceptance).
class DiffuseLobe final : public Bsdf {
public:
    /// `of` must outlive it.
    DiffuseLobe(const Bsdf& of, Rgb reflectance) noexcept : of_(of), reflectance_(reflectance) {}
    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override {
        return wo.z * wi.z > 0 ? reflectance_ * (inv_pi * of_.diffuse_acceptance(wi)) : Rgb{};
    }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override {
        return wo.z * wi.z > 0 && any(which & Lobe::diffuse) ? std::abs(wi.z) * inv_pi : 0;
    }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float, Vec2 u, Lobe which) const noexcept override {
        Vec3 wi = sample_cosine_hemisphere(u);
        if (!any(which & Lobe::diffuse) || !(wi.z > 0)) return {};
        const float density = wi.z * inv_pi;
        if (wo.z < 0) wi.z = -wi.z;
        return {wi, reflectance_ * of_.diffuse_acceptance(wi), density, Lobe::diffuse};
    }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return {.diffuse = reflectance_}; }
    [[nodiscard]] float diffuse_acceptance(Vec3 wi) const noexcept override { return of_.diffuse_acceptance(wi); }

private:
    const Bsdf& of_;
    Rgb reflectance_;
};

}  // namespace cardioid::photon

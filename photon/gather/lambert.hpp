#pragma once
#include "rt_core/api/bsdf.hpp"

namespace cardioid::photon {

/// A diffuse lobe by itself: asks World::direct what light a surface turns back by this lobe alone, and with
/// reflectance pi for irradiance.
class Lambert final : public Bsdf {
public:
    explicit Lambert(Rgb reflectance) noexcept : f_(reflectance * inv_pi) {}
    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override { return wo.z * wi.z > 0 ? f_ : Rgb{}; }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override {
        return wo.z * wi.z > 0 && any(which & Lobe::diffuse) ? std::abs(wi.z) * inv_pi : 0;
    }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float, Vec2 u, Lobe which) const noexcept override {
        Vec3 wi = sample_cosine_hemisphere(u);
        if (!any(which & Lobe::diffuse) || !(wi.z > 0)) return {};
        const float density = wi.z * inv_pi;
        if (wo.z < 0) wi.z = -wi.z;
        return {wi, f_ * pi, density, Lobe::diffuse};
    }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return {.diffuse = f_ * pi}; }

private:
    Rgb f_;
};

}  // namespace cardioid::photon

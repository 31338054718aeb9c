#pragma once
#include "shaders/materials/lobes.hpp"
#include "shaders/optics/directional_table.hpp"
#include "shaders/optics/fresnel.hpp"
#include "shaders/optics/ggx.hpp"

namespace cardioid::shaders {

/// The indices on both sides of a boundary as seen from wo, whose side is turned up.
struct Boundary {
    float eta_front, eta_back;
    /// Index behind the boundary over the index on wo's side.
    [[nodiscard]] float eta(Vec3 wo) const { return wo.z > 0 ? eta_back / eta_front : eta_front / eta_back; }
};

/// A smooth boundary: mirror and refraction, chosen by Fresnel's reflectance.
class SmoothDielectricBsdf final : public Bsdf {
public:
    explicit SmoothDielectricBsdf(Boundary boundary) : boundary_(boundary) {}

    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::specular | Lobe::transmitted; }
    [[nodiscard]] Rgb f(Vec3, Vec3) const noexcept override { return {}; }
    [[nodiscard]] float pdf(Vec3, Vec3, Lobe) const noexcept override { return 0; }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float u_lobe, Vec2 u, Lobe which) const noexcept override;
    [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept override;

private:
    Boundary boundary_;
};

/// Shares that a rough boundary reflects and lets through; the rest is lost between its facets.
struct Shares {
    float reflected = 0, transmitted = 0;
    friend Shares operator+(Shares a, Shares b) { return {a.reflected + b.reflected, a.transmitted + b.transmitted}; }
    friend Shares operator*(Shares a, float s) { return {a.reflected * s, a.transmitted * s}; }
};

/// Shares for light seen along a direction of cosine cos_o, as the mean over visible facets.
Shares rough_dielectric_shares(Ggx ggx, float eta, float cos_o, const SquareLattice& lattice);

/// What a material knows of itself beforehand: its shares when it borders on empty space.
struct RoughDielectricData {
    Ggx ggx{0};
    float ior = 1;
    DirectionalTable<Shares> from_outside, from_inside;
    /// alpha > 0.
    RoughDielectricData(float alpha, float ior_of_material);
};

/// A rough boundary (Walter et al. 2007, eqs 20-21 and 38-41, G1 G1 for transmission).
class RoughDielectricBsdf final : public Bsdf {
public:
    RoughDielectricBsdf(const RoughDielectricData& data, Boundary boundary) : data_(&data), boundary_(boundary) {}

    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::glossy | Lobe::transmitted; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override;
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override;
    [[nodiscard]] BsdfSample sample(Vec3 wo, float u_lobe, Vec2 u, Lobe which) const noexcept override;
    [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept override;

private:
    const RoughDielectricData* data_;
    Boundary boundary_;
};

}  // namespace cardioid::shaders

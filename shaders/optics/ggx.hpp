#pragma once
#include <algorithm>
#include <cmath>

#include "rt_core/api/math.hpp"

namespace cardioid::shaders {

/// Facets of a rough surface with the GGX distribution (Walter et al. 2007, eqs 33-34), Smith shadowing and
/// visible-normal sampling (Heitz 2018, "Sampling the GGX Distribution of Visible Normals"). All directions are local
/// with z >= 0. Written so that nothing is divided by a cosine: grazing directions stay finite.
struct Ggx {
    float alpha;  ///< width, > 0

    /// Below this width a lobe is narrower than float directions resolve: treat the surface as smooth.
    static constexpr float smoothest = 1e-4F;
    /// The parameter `roughness` in [0, 1] is perceptual: alpha = roughness^2 (Burley 2012). 0 where that is smooth.
    static float alpha_of(double roughness) {
        const auto a = static_cast<float>(roughness * roughness);
        return a < smoothest ? 0 : a;
    }

    /// Area of facets per steradian of normals h.
    [[nodiscard]] float density(Vec3 h) const noexcept {
        const float a2 = alpha * alpha;
        const float e = (h.x * h.x + h.y * h.y) / a2 + h.z * h.z;
        return inv_pi / (a2 * e * e);
    }
    /// z sqrt(1 + alpha^2 tan^2), from which Smith's functions are made.
    [[nodiscard]] float stretched(Vec3 w) const noexcept {
        return std::sqrt(w.z * w.z + alpha * alpha * (w.x * w.x + w.y * w.y));
    }
    /// Smith's G1(w) / (2 w.z).
    [[nodiscard]] float masking_over_2z(Vec3 w) const noexcept { return 1 / (w.z + stretched(w)); }
    /// Height-correlated G2(a, b) / (4 a.z b.z) (Heitz 2014, eq. 99).
    [[nodiscard]] float shadowing_over_4zz(Vec3 a, Vec3 b) const noexcept {
        return 0.5F / std::max(stretched(a) * b.z + stretched(b) * a.z, 1e-20F);
    }
    /// A facet normal seen from wo, with density masking(wo) density(h) dot(wo, h) / wo.z.
    [[nodiscard]] Vec3 sample_visible(Vec3 wo, Vec2 u) const noexcept {
        const Vec3 v = normalize(Vec3{alpha * wo.x, alpha * wo.y, wo.z});
        const float flat = v.x * v.x + v.y * v.y;
        const Vec3 t1 = flat > 0 ? Vec3{-v.y, v.x, 0} * (1 / std::sqrt(flat)) : Vec3{1, 0, 0};
        const Vec3 t2 = cross(v, t1);
        const float r = std::sqrt(u.x), phi = 2 * pi * u.y, s = 0.5F * (1 + v.z);
        const float a = r * std::cos(phi);
        const float b = (1 - s) * std::sqrt(std::max(0.0F, 1 - a * a)) + s * r * std::sin(phi);
        const Vec3 n = t1 * a + t2 * b + v * std::sqrt(std::max(0.0F, 1 - a * a - b * b));
        // Never a zero vector, even where all of n.x, n.y, n.z round to 0.
        return normalize(Vec3{alpha * n.x, alpha * n.y, std::max(1e-7F, n.z)});
    }
    /// Density per steradian of h with which sample_visible(wo) draws it.
    [[nodiscard]] float visible_density(Vec3 wo, Vec3 h) const noexcept {
        return 2 * masking_over_2z(wo) * density(h) * std::max(0.0F, dot(wo, h));
    }
};

/// The facet that mirrors a into b, both with z >= 0; the surface's own normal where they graze it from opposite sides.
inline Vec3 half_vector(Vec3 a, Vec3 b) noexcept {
    const Vec3 sum = a + b;
    const float square = dot(sum, sum);
    return square > 1e-20F ? sum * (1 / std::sqrt(square)) : Vec3{0, 0, 1};
}

/// wo mirrored at a facet of normal h.
inline Vec3 reflect(Vec3 wo, Vec3 h) noexcept { return h * (2 * dot(wo, h)) - wo; }

/// Points that fill the unit square evenly, for means of functions on it (Fibonacci lattice; Sloan, Joe 1994).
struct SquareLattice {
    int points, generator;
    static const SquareLattice coarse, fine;
    [[nodiscard]] Vec2 operator[](int i) const {
        const float n = static_cast<float>(points);
        return {(static_cast<float>(i) + 0.5F) / n, (static_cast<float>(i * generator % points) + 0.5F) / n};
    }
};
inline constexpr SquareLattice SquareLattice::coarse{377, 233}, SquareLattice::fine{987, 610};

/// Mean over the visible facets of f(facet cosine, shadowing / masking) by which a rough mirror of that Fresnel
/// function reflects light seen along a direction of cosine cos_o: its directional albedo.
template <class T, class Fresnel>
T rough_reflectance(Ggx ggx, double cos_o, Fresnel&& fresnel) {
    const Vec3 wo(static_cast<float>(std::sqrt(std::max(0.0, 1 - cos_o * cos_o))), 0, static_cast<float>(cos_o));
    T sum{};
    for (int i = 0; i < SquareLattice::fine.points; ++i) {
        const Vec3 h = ggx.sample_visible(wo, SquareLattice::fine[i]), wi = reflect(wo, h);
        if (wi.z <= 0) continue;
        sum += fresnel(dot(wo, h)) * (2 * wi.z * ggx.shadowing_over_4zz(wo, wi) / ggx.masking_over_2z(wo));
    }
    return sum * (1 / static_cast<float>(SquareLattice::fine.points));
}

}  // namespace cardioid::shaders

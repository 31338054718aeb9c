#pragma once
#include <algorithm>
#include <cmath>

#include "rt_core/api/math.hpp"

namespace cardioid::shaders {

/// Cosine of the bent ray behind a boundary (Snell's law), 0 under total internal reflection; cos_o in [0, 1] and eta
/// as for fresnel_dielectric.
inline double cosine_behind(double cos_o, double eta) noexcept {
    return std::sqrt(std::max(0.0, 1 - (1 - cos_o * cos_o) / (eta * eta)));
}

/// Shares of light of both polarisations that a smooth boundary reflects: across and within the plane of incidence.
struct PolarisedReflectance {
    double s, p;
};

/// Fresnel's equations. cos_o in [0, 1] is on the side the light is seen from; eta = index of the other side / index of
/// that side. Both are 1 under total internal reflection.
inline PolarisedReflectance fresnel_polarised(double cos_o, double eta) noexcept {
    const double c = std::clamp(cos_o, 0.0, 1.0);
    const double t = cosine_behind(c, eta);
    if (t <= 0) return {1, 1};
    const double s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
    return {s * s, p * p};
}

/// The share of unpolarised light: the mean of both.
inline double fresnel_dielectric(double cos_o, double eta) noexcept {
    const PolarisedReflectance r = fresnel_polarised(cos_o, eta);
    return (r.s + r.p) / 2;
}

/// The same for a metal of complex index eta + i k, both relative to the outside (Born & Wolf, 14.2; in the real form
/// of Lagarde 2013, "Memo on Fresnel equations").
inline double fresnel_conductor(double cos_o, double eta, double k) noexcept {
    const double c = std::clamp(cos_o, 0.0, 1.0), c2 = c * c, s2 = 1 - c2;
    const double t0 = eta * eta - k * k - s2;
    const double a2b2 = std::sqrt(t0 * t0 + 4 * eta * eta * k * k);
    const double t1 = a2b2 + c2;
    const double t2 = 2 * c * std::sqrt(std::max(0.0, (a2b2 + t0) / 2));
    const double t3 = c2 * a2b2 + s2 * s2, t4 = t2 * s2;
    if (t1 + t2 <= 0 || t3 + t4 <= 0) return 1;
    const double rs = (t1 - t2) / (t1 + t2);
    return rs * (1 + (t3 - t4) / (t3 + t4)) / 2;
}

inline Rgb fresnel_conductor(float cos_o, Rgb eta, Rgb k) noexcept {
    const auto channel = [&](float e, float x) { return static_cast<float>(fresnel_conductor(double{cos_o}, e, x)); };
    return {channel(eta.r, k.r), channel(eta.g, k.g), channel(eta.b, k.b)};
}

/// Integral of 2 c f(c) over the cosine c in [0, 1]: what a diffuse source sees of f.
template <class F>
double diffuse_average(F&& f) {
    constexpr int n = 2048;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double c = (i + 0.5) / n;
        sum += 2 * c * f(c);
    }
    return sum / n;
}

/// Share of diffuse light from outside that a smooth body of index eta >= 1 reflects.
inline double diffuse_fresnel_outside(double eta) {
    return diffuse_average([eta](double c) { return fresnel_dielectric(c, eta); });
}

/// Share of diffuse light inside that is thrown back, from the same outside: radiance / index^2 is kept along a ray
/// in both directions, so (1 - inside) eta^2 = 1 - outside.
inline double diffuse_fresnel_inside(double outside, double eta) { return 1 - (1 - outside) / (eta * eta); }

/// The direction into which light seen along wo (unit, dot(wo, h) > 0) is bent at a facet of normal h, away from the
/// facet on its other side. Zero vector under total internal reflection. eta as for fresnel_dielectric.
inline Vec3 refract(Vec3 wo, Vec3 h, float eta) noexcept {
    const double c = double{dot(wo, h)}, e = double{eta};
    const double t = cosine_behind(std::min(c, 1.0), e);
    if (t <= 0) return {};
    const auto along_h = static_cast<float>(c / e - t);
    return h * along_h - wo * (1 / eta);
}

}  // namespace cardioid::shaders

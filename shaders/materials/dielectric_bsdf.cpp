#include "shaders/materials/dielectric_bsdf.hpp"

namespace cardioid::shaders {
namespace {

/// A pair of directions with wo turned to z > 0.
struct Pair {
    Vec3 wo, wi;
    Pair(Vec3 o, Vec3 i) : wo(o.z < 0 ? flip_z(o) : o), wi(o.z < 0 ? flip_z(i) : i) {}
};

float fresnel(Vec3 wo, Vec3 h, float eta) {
    return static_cast<float>(fresnel_dielectric(double{dot(wo, h)}, double{eta}));
}

/// The facet that bends light from wi to wo (Walter et al. 2007, eq. 16), turned to z > 0.
Vec3 bending_facet(const Pair& w, float eta) {
    const Vec3 h = normalize(w.wo + w.wi * eta);
    return h.z < 0 ? -h : h;
}

/// D |cos_o cos_i| / (cos_o + eta cos_i)^2 of the bending facet h, 0 where light cannot go that way.
float bending(const Ggx& ggx, const Pair& w, Vec3 h, float eta) {
    const float cos_o = dot(w.wo, h), cos_i = dot(w.wi, h);
    if (cos_o <= 0 || cos_i >= 0) return 0;
    const float sum = cos_o + eta * cos_i;
    return ggx.density(h) * cos_o * -cos_i / (sum * sum);
}

}  // namespace

BsdfSample SmoothDielectricBsdf::sample(Vec3 wo, float u_lobe, Vec2, Lobe which) const noexcept {
    if (!within(Lobe::specular, which) || wo.z == 0) return {};
    const float eta = boundary_.eta(wo), cosine = std::abs(wo.z);
    const auto reflected = static_cast<float>(fresnel_dielectric(double{cosine}, double{eta}));
    const bool both = within(Lobe::specular | Lobe::transmitted, which);
    if (!both && reflected <= 0) return {};
    if (!both || u_lobe < reflected) return {{-wo.x, -wo.y, wo.z}, Rgb(both ? 1 : reflected), 0, Lobe::specular};
    const auto cos_t = static_cast<float>(cosine_behind(double{cosine}, double{eta}));
    return {{-wo.x / eta, -wo.y / eta, std::copysign(cos_t, -wo.z)},
            Rgb(1 / (eta * eta)),
            0,
            Lobe::specular | Lobe::transmitted};
}

Albedo SmoothDielectricBsdf::albedo(Vec3 wo) const noexcept {
    const auto reflected = static_cast<float>(fresnel_dielectric(double{std::abs(wo.z)}, double{boundary_.eta(wo)}));
    return {.specular = Rgb(reflected), .transmitted = Rgb(1 - reflected)};
}

Shares rough_dielectric_shares(Ggx ggx, float eta, float cos_o, const SquareLattice& lattice) {
    const Vec3 wo(std::sqrt(std::max(0.0F, 1 - cos_o * cos_o)), 0, cos_o);
    Shares sum;
    for (int i = 0; i < lattice.points; ++i) {
        const Vec3 h = ggx.sample_visible(wo, lattice[i]);
        const Vec3 up = reflect(wo, h), down = flip_z(refract(wo, h, eta));
        const float r = fresnel(wo, h, eta);
        if (up.z > 0) sum.reflected += r * 2 * up.z * ggx.shadowing_over_4zz(wo, up) / ggx.masking_over_2z(wo);
        if (down.z > 0) sum.transmitted += (1 - r) * 2 * down.z * ggx.masking_over_2z(down);
    }
    return sum * (1 / static_cast<float>(lattice.points));
}

RoughDielectricData::RoughDielectricData(float alpha, float ior_of_material) : ggx{alpha}, ior(ior_of_material) {
    const auto table = [&](float eta) {
        return DirectionalTable<Shares>(
            [&](double c) { return rough_dielectric_shares(ggx, eta, static_cast<float>(c), SquareLattice::fine); });
    };
    from_outside = table(ior);
    from_inside = table(1 / ior);
}

Rgb RoughDielectricBsdf::f(Vec3 wo, Vec3 wi) const noexcept {
    if (wo.z == 0 || wi.z == 0) return {};
    const Pair w(wo, wi);
    const float eta = boundary_.eta(wo);
    const Ggx& ggx = data_->ggx;
    if (w.wi.z > 0) {
        const Vec3 h = half_vector(w.wo, w.wi);
        return Rgb(fresnel(w.wo, h, eta) * ggx.density(h) * ggx.shadowing_over_4zz(w.wo, w.wi));
    }
    const Vec3 h = bending_facet(w, eta);
    const float through = bending(ggx, w, h, eta);
    if (through <= 0) return {};
    return Rgb((1 - fresnel(w.wo, h, eta)) * through * 4 * ggx.masking_over_2z(w.wo) *
               ggx.masking_over_2z(flip_z(w.wi)));
}

float RoughDielectricBsdf::pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept {
    if (wo.z == 0 || wi.z == 0 || !within(Lobe::glossy, which)) return 0;
    const Pair w(wo, wi);
    const float eta = boundary_.eta(wo);
    const Ggx& ggx = data_->ggx;
    const bool both = within(Lobe::glossy | Lobe::transmitted, which);
    if (w.wi.z > 0) {
        const Vec3 h = half_vector(w.wo, w.wi);
        return (both ? fresnel(w.wo, h, eta) : 1) * ggx.density(h) * ggx.masking_over_2z(w.wo) / 2;
    }
    if (!both) return 0;
    const Vec3 h = bending_facet(w, eta);
    const float through = bending(ggx, w, h, eta);
    if (through <= 0) return 0;
    return (1 - fresnel(w.wo, h, eta)) * through * 2 * ggx.masking_over_2z(w.wo) * eta * eta;
}

BsdfSample RoughDielectricBsdf::sample(Vec3 wo, float u_lobe, Vec2 u, Lobe which) const noexcept {
    if (wo.z == 0 || !within(Lobe::glossy, which)) return {};
    const Pair w(wo, wo);
    const float eta = boundary_.eta(wo);
    const Ggx& ggx = data_->ggx;
    const Vec3 h = ggx.sample_visible(w.wo, u);
    const float reflected = fresnel(w.wo, h, eta);
    const bool both = within(Lobe::glossy | Lobe::transmitted, which);
    const bool up = !both || u_lobe < reflected;
    Vec3 wi = up ? reflect(w.wo, h) : refract(w.wo, h, eta);
    if (up ? wi.z <= 0 : wi.z >= 0) return {};
    float weight = 0;
    if (up)
        weight = (both ? 1 : reflected) * 2 * wi.z * ggx.shadowing_over_4zz(w.wo, wi) / ggx.masking_over_2z(w.wo);
    else
        weight = -2 * wi.z * ggx.masking_over_2z(flip_z(wi)) / (eta * eta);
    if (wo.z < 0) wi = flip_z(wi);
    const float density = pdf(wo, wi, which);
    if (!(density > 0)) return {};
    return {wi, Rgb(weight), density, up ? Lobe::glossy : Lobe::glossy | Lobe::transmitted};
}

Albedo RoughDielectricBsdf::albedo(Vec3 wo) const noexcept {
    const float eta = boundary_.eta(wo), cosine = std::abs(wo.z);
    const auto is = [eta](float known) { return std::abs(eta - known) <= 1e-5F * known; };
    const Shares s = is(data_->ior)       ? data_->from_outside(cosine)
                     : is(1 / data_->ior) ? data_->from_inside(cosine)
                                          : rough_dielectric_shares(data_->ggx, eta, cosine, SquareLattice::coarse);
    return {.specular = Rgb(s.reflected), .transmitted = Rgb(s.transmitted)};
}

}  // namespace cardioid::shaders

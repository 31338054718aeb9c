/// `conductor`: bare metal.
///
///     define_material("ring", kind = "conductor", metal = "gold", roughness = 0.3)
///     define_material("own", kind = "conductor", eta = [0.2, 0.9, 1.1], k = [3.9, 2.4, 2.1])
///
/// | parameter   | default | |
/// |-------------|---------|---|
/// | `metal`     | "aluminium" | aluminium, chromium, copper, gold, iron, nickel, silver, titanium |
/// | `eta`, `k`  | of the metal | complex index of refraction per channel, instead of `metal`; give both |
/// | `roughness` | 0       | 0 (mirror-smooth) to 1; GGX with alpha = roughness^2 |
///
/// Smooth: a mirror by Fresnel's equations for complex indices. Rough: F D G2 / (4 cos cos) with the GGX distribution
/// (Walter et al. 2007), Smith's height-correlated shadowing and visible-normal sampling (Heitz 2014, 2018). Light that
/// would meet a second facet is lost: from above, a metal that absorbs nothing reflects 0.99 at roughness 0.3, 0.92 at
/// 0.5 and 0.31 at 1. albedo() has what is left.
#include "shaders/materials/lobes.hpp"
#include "shaders/materials/materials.hpp"
#include "shaders/materials/metals.hpp"
#include "shaders/optics/directional_table.hpp"
#include "shaders/optics/fresnel.hpp"
#include "shaders/optics/ggx.hpp"

namespace cardioid::shaders {
namespace {

struct ConductorData {
    Rgb eta, k;
    Ggx ggx{0};                   ///< alpha 0: smooth
    DirectionalTable<Rgb> share;  ///< reflected, over the cosine; rough metals only
    [[nodiscard]] Rgb fresnel(float cosine) const { return fresnel_conductor(cosine, eta, k); }
};

class SmoothConductorBsdf final : public Bsdf {
public:
    explicit SmoothConductorBsdf(const ConductorData& data) : data_(&data) {}

    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::specular; }
    [[nodiscard]] Rgb f(Vec3, Vec3) const noexcept override { return {}; }
    [[nodiscard]] float pdf(Vec3, Vec3, Lobe) const noexcept override { return 0; }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float, Vec2, Lobe which) const noexcept override {
        if (!within(Lobe::specular, which) || wo.z == 0) return {};
        return {{-wo.x, -wo.y, wo.z}, data_->fresnel(std::abs(wo.z)), 0, Lobe::specular};
    }
    [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept override {
        return {.specular = data_->fresnel(std::abs(wo.z))};
    }

private:
    const ConductorData* data_;
};

class RoughConductorBsdf final : public Bsdf {
public:
    explicit RoughConductorBsdf(const ConductorData& data) : data_(&data) {}

    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::glossy; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override {
        if (wo.z * wi.z <= 0) return {};
        const Vec3 o = upper(wo), i = upper(wi), h = half_vector(o, i);
        return data_->fresnel(dot(o, h)) * (data_->ggx.density(h) * data_->ggx.shadowing_over_4zz(o, i));
    }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override {
        if (wo.z * wi.z <= 0 || !within(Lobe::glossy, which)) return 0;
        const Vec3 o = upper(wo), h = half_vector(o, upper(wi));
        return data_->ggx.density(h) * data_->ggx.masking_over_2z(o) / 2;
    }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float, Vec2 u, Lobe which) const noexcept override {
        if (!within(Lobe::glossy, which) || wo.z == 0) return {};
        const Vec3 o = upper(wo), h = data_->ggx.sample_visible(o, u);
        Vec3 wi = reflect(o, h);
        if (wi.z <= 0) return {};
        const float masking = data_->ggx.masking_over_2z(o);
        const Rgb weight = data_->fresnel(dot(o, h)) * (2 * wi.z * data_->ggx.shadowing_over_4zz(o, wi) / masking);
        const float density = data_->ggx.density(h) * masking / 2;
        if (wo.z < 0) wi = flip_z(wi);
        return {wi, weight, density, Lobe::glossy};
    }
    [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept override { return {.specular = data_->share(std::abs(wo.z))}; }

private:
    static Vec3 upper(Vec3 w) { return {w.x, w.y, std::abs(w.z)}; }

    const ConductorData* data_;
};

class ConductorShader final : public Shader {
public:
    explicit ConductorShader(const ConductorData& data) : data_(data) {
        if (data_.ggx.alpha > 0)
            data_.share = DirectionalTable<Rgb>([&](double c) {
                return rough_reflectance<Rgb>(data_.ggx, c, [&](float facet) { return data_.fresnel(facet); });
            });
    }
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept override {
        if (data_.ggx.alpha > 0) return memory.make<RoughConductorBsdf>(data_);
        return memory.make<SmoothConductorBsdf>(data_);
    }

private:
    ConductorData data_;
};

constexpr ParamSpec params[] = {
    {"metal", ParamType::text, "\"aluminium\"", "aluminium, chromium, copper, gold, iron, nickel, silver or titanium"},
    {"eta", ParamType::colour, "of the metal", "real part of the index of refraction, per channel, above 0"},
    {"k", ParamType::colour, "of the metal", "imaginary part of the index of refraction, per channel, 0 or more"},
    {"roughness", ParamType::number, "0", "0 (mirror-smooth) to 1"}};

std::shared_ptr<const Shader> make(const ShaderInputs& in) {
    ConductorData data;
    const bool own = in.params.has("eta") || in.params.has("k");
    if (own) {
        if (in.params.has("metal")) in.params.wrong("metal", "left out where eta and k are given");
        if (!in.params.has("eta")) in.params.wrong("eta", "given together with k");
        if (!in.params.has("k")) in.params.wrong("k", "given together with eta");
        data.eta = in.params.colour("eta", {}, 0, 100);
        data.k = in.params.colour("k", {}, 0, 100);
        if (min_component(data.eta) <= 0) in.params.wrong("eta", "above 0");
    } else {
        const std::string name = in.params.text("metal", "aluminium");
        const Metal* metal = find_metal(name);
        if (!metal) in.params.wrong("metal", metal_names(name));
        data.eta = metal->eta, data.k = metal->k;
    }
    data.ggx.alpha = Ggx::alpha_of(in.params.number("roughness", 0, 0, 1));
    return std::make_shared<ConductorShader>(data);
}

}  // namespace

const ShaderKind conductor_kind{"conductor", "bare metal, smooth or rough", params, make};

}  // namespace cardioid::shaders

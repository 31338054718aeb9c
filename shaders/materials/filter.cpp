/// `filter`: a thin coloured film, such as OpenSCAD's color([r, g, b, alpha]) means. Light goes straight through or is
/// reflected diffusely; nothing is bent.
///
///     define_material("foil", kind = "filter", reflectance = [1, 0, 0], transmittance = 0.6)
///
/// | parameter       | default | |
/// |-----------------|---------|---|
/// | `reflectance`   | 0.5     | albedo per channel of the share that does not pass, 0 to 1 |
/// | `transmittance` | 0.5     | share that passes one crossing of the surface, per channel, 0 to 1 (1 - alpha) |
///
/// albedo = transmittance + (1 - transmittance) reflectance. A closed solid is crossed twice. Shadow rays pass too.
#include "shaders/materials/lobes.hpp"
#include "shaders/materials/materials.hpp"

namespace cardioid::shaders {
namespace {

constexpr Lobe straight = Lobe::specular | Lobe::transmitted;

class FilterBsdf final : public Bsdf {
public:
    FilterBsdf(Rgb reflectance, Rgb transmittance) : reflectance_(reflectance), transmittance_(transmittance) {}

    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse | straight; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override {
        return wo.z * wi.z > 0 ? reflectance_ * inv_pi : Rgb{};
    }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override {
        return wo.z * wi.z > 0 ? choice(which).first * std::abs(wi.z) * inv_pi : 0;
    }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float u_lobe, Vec2 u, Lobe which) const noexcept override {
        const LobeChoice p = choice(which);
        if (p.none() || wo.z == 0) return {};
        if (u_lobe >= p.first) return {-wo, transmittance_ / p.second, 0, straight};
        Vec3 wi = sample_cosine_hemisphere(u);
        if (wi.z <= 0) return {};
        if (wo.z < 0) wi = flip_z(wi);
        return {wi, reflectance_ / p.first, p.first * std::abs(wi.z) * inv_pi, Lobe::diffuse};
    }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override {
        return {.diffuse = reflectance_, .transmitted = transmittance_};
    }

private:
    [[nodiscard]] LobeChoice choice(Lobe which) const noexcept {
        return {within(Lobe::diffuse, which) ? average(reflectance_) : 0,
                within(straight, which) ? average(transmittance_) : 0};
    }
    Rgb reflectance_;  ///< of all light, not only of what does not pass
    Rgb transmittance_;
};

class FilterShader final : public Shader {
public:
    FilterShader(Rgb reflectance, Rgb transmittance)
        : reflectance_((Rgb(1) - transmittance) * reflectance), transmittance_(transmittance) {}
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept override {
        return memory.make<FilterBsdf>(reflectance_, transmittance_);
    }
    [[nodiscard]] const Medium* interior() const noexcept override { return &air_; }
    [[nodiscard]] Rgb straight_transmittance(const SurfacePoint&, Vec3) const noexcept override {
        return transmittance_;
    }
    [[nodiscard]] bool filters() const noexcept override { return true; }

private:
    Rgb reflectance_, transmittance_;
    Medium air_;  ///< light does enter such a solid, but nothing happens to it there
};

constexpr ParamSpec params[] = {
    {"reflectance", ParamType::colour, "0.5", "diffuse reflectance of the share that does not pass, 0 to 1"},
    {"transmittance", ParamType::colour, "0.5", "share of light that goes straight through one crossing, 0 to 1"}};

std::shared_ptr<const Shader> make(const ShaderInputs& in) {
    return std::make_shared<FilterShader>(in.params.colour("reflectance", Rgb(0.5F), 0, 1),
                                          in.params.colour("transmittance", Rgb(0.5F), 0, 1));
}

}  // namespace

const ShaderKind filter_kind{"filter", "thin coloured film: light goes straight through or is scattered", params, make};

}  // namespace cardioid::shaders

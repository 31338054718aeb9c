/// `pov_finish`: the matt and shiny surface of POV-Ray 3.7, for pictures that are compared with its own.
///
///     define_material("knob", kind = "pov_finish", pigment = [0.6, 0.1, 0.1], diffuse = 0.7, phong = 0.5)
///
/// | parameter    | default | |
/// |--------------|---------|---|
/// | `pigment`    | 0.5     | colour of the body per channel, 0 to 1 |
/// | `diffuse`    | 1       | share of the pigment that is reflected evenly, 0 to 1 |
/// | `brilliance` | 1       | exponent of the cosine towards the light, 0 to 100 |
/// | `phong`      | 0       | brightness of Phong's highlight, 0 to 100 |
/// | `phong_size` | 40      | its exponent, 0 to 1e5 |
/// | `specular`   | 0       | brightness of Blinn's highlight, 0 to 100 |
/// | `roughness`  | 0.05    | one over its exponent, 1e-5 to 1 |
/// | `metallic`   | 0       | how far the highlights take the pigment's colour, 0 to 1 |
///
/// Light of radiance L from wi within dw adds, over pi (measured with POV-Ray 3.7.0.10),
///     L dw (diffuse pigment cos^brilliance + tint (phong cos^phong_size alpha + specular (n.h)^(1/roughness)))
/// with alpha the angle between wi and the mirrored wo. The highlights have no cosine, so this does not keep to the
/// conservation of energy and is not reciprocal; a scene to be looked at wants `phong` or `plastic`.
#include <cmath>

#include "shaders/materials/lobes.hpp"
#include "shaders/materials/materials.hpp"

namespace cardioid::shaders {
namespace {

struct Finish {
    Rgb pigment;
    float diffuse = 1, brilliance = 1;
    float phong = 0, phong_size = 40;
    float specular = 0, roughness = 0.05F;
    float metallic = 0;
};

class PovFinishBsdf final : public Bsdf {
public:
    explicit PovFinishBsdf(const Finish& finish) : finish_(&finish) {}

    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override {
        if (wo.z * wi.z <= 0) return {};
        const float cosine = std::abs(wi.z);
        const Rgb body = finish_->pigment * (finish_->diffuse * std::pow(cosine, finish_->brilliance));
        return (body + highlights(wo, wi, cosine)) * (inv_pi / cosine);
    }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override {
        return wo.z * wi.z > 0 && within(Lobe::diffuse, which) ? std::abs(wi.z) * inv_pi : 0;
    }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float, Vec2 u, Lobe which) const noexcept override {
        if (!within(Lobe::diffuse, which) || wo.z == 0) return {};
        Vec3 wi = sample_cosine_hemisphere(u);
        if (wi.z <= 0) return {};
        if (wo.z < 0) wi = flip_z(wi);
        const float density = std::abs(wi.z) * inv_pi;
        return {wi, f(wo, wi) * (std::abs(wi.z) / density), density, Lobe::diffuse};
    }
    /// POV-Ray's radiosity and photons know the body only.
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override {
        return {.diffuse = finish_->pigment * finish_->diffuse};
    }

private:
    [[nodiscard]] Rgb highlights(Vec3 wo, Vec3 wi, float cosine) const noexcept {
        float sum = 0;
        if (finish_->phong > 0) {
            const float alpha = dot(wi, Vec3{-wo.x, -wo.y, wo.z});
            if (alpha > 0) sum += finish_->phong * std::pow(alpha, finish_->phong_size);
        }
        if (finish_->specular > 0) {
            const float half = std::abs(normalize(wo + wi).z);
            sum += finish_->specular * std::pow(half, 1 / finish_->roughness);
        }
        return sum > 0 ? tint(cosine) * sum : Rgb{};
    }
    /// The pigment from the front, white at grazing angles (Cook, Torrance 1982, with POV-Ray's fit of Fresnel).
    [[nodiscard]] Rgb tint(float cosine) const noexcept {
        if (finish_->metallic == 0) return Rgb(1);
        const float x = std::acos(std::min(cosine, 1.0F)) * 2 * inv_pi - 1.12F;
        const float fresnel = std::clamp(0.014567225F / (x * x) - 0.011612903F, 0.0F, 1.0F);
        return Rgb(1) + (finish_->pigment - Rgb(1)) * (finish_->metallic * (1 - fresnel));
    }

    const Finish* finish_;
};

class PovFinishShader final : public Shader {
public:
    explicit PovFinishShader(const Finish& finish) : finish_(finish) {}
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept override {
        return memory.make<PovFinishBsdf>(finish_);
    }

private:
    Finish finish_;
};

constexpr ParamSpec params[] = {
    {"pigment", ParamType::colour, "0.5", "colour of the body, 0 to 1"},
    {"diffuse", ParamType::number, "1", "share of the pigment that is reflected evenly, 0 to 1"},
    {"brilliance", ParamType::number, "1", "exponent of the cosine towards the light, 0 to 100"},
    {"phong", ParamType::number, "0", "brightness of Phong's highlight, 0 to 100"},
    {"phong_size", ParamType::number, "40", "its exponent, 0 to 1e5"},
    {"specular", ParamType::number, "0", "brightness of Blinn's highlight, 0 to 100"},
    {"roughness", ParamType::number, "0.05", "one over its exponent, 1e-5 to 1"},
    {"metallic", ParamType::number, "0", "how far the highlights take the pigment's colour, 0 to 1"}};

std::shared_ptr<const Shader> make(const ShaderInputs& in) {
    const auto number = [&](const char* name, double fallback, double lo, double hi) {
        return static_cast<float>(in.params.number(name, fallback, lo, hi));
    };
    Finish finish;
    finish.pigment = in.params.colour("pigment", Rgb(0.5F), 0, 1);
    finish.diffuse = number("diffuse", 1, 0, 1);
    finish.brilliance = number("brilliance", 1, 0, 100);
    finish.phong = number("phong", 0, 0, 100);
    finish.phong_size = number("phong_size", 40, 0, 1e5);
    finish.specular = number("specular", 0, 0, 100);
    finish.roughness = number("roughness", 0.05, 1e-5, 1);
    finish.metallic = number("metallic", 0, 0, 1);
    return std::make_shared<PovFinishShader>(finish);
}

}  // namespace

const ShaderKind pov_finish_kind{"pov_finish", "matt and shiny surface of POV-Ray, for comparing with it", params,
                                 make};

}  // namespace cardioid::shaders

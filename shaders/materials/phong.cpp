/// `phong`: a diffuse and a shiny share, the model of ARL-TR-3608 and of BRL-CAD.
///
///     define_material("knob", kind = "phong", diffuse = [0.5, 0.1, 0.1], specular = 0.3, exponent = 50)
///     define_material("old", kind = "phong", normalized = false, attenuation = [0.1, 1, 0.01])
///
/// | parameter       | default | |
/// |-----------------|---------|---|
/// | `diffuse`       | 0.5     | kd, per channel |
/// | `specular`      | 0.2     | ks, per channel; diffuse + specular at most 1 |
/// | `exponent`      | 20      | n, 0 to 1e6; the lobe's half width is about sqrt(1.4 / n) radians |
/// | `normalized`    | true    | false: the report's equation 7, which does not conserve energy |
/// | `attenuation`   | none    | [a, b, c]: direct light falls off as 1/(a + b d + c d^2) instead of 1/d^2 (note [9]) |
/// | `attenuation_p` | none    | p [unit^2]: the same with 1/(p + d^2) |
///
/// Normalised (Lafortune & Willems 1994), with alpha the angle between wi and the mirrored wo, cos alpha >= 0:
///     f = kd / pi + ks (n + 2) / (2 pi) cos^n alpha
/// which is reciprocal and reflects at most kd + ks, less at grazing angles where part of the lobe is below the
/// surface. Equation 7 of the report is f cos(theta_i) = kd cos(theta_i) + ks cos^n alpha; its kd and ks are taken as
/// the shares of reflected light in photon propagation, as equations 2 to 4 have it.
#include <cmath>

#include "shaders/materials/lobes.hpp"
#include "shaders/materials/materials.hpp"
#include "shaders/optics/directional_table.hpp"

namespace cardioid::shaders {
namespace {

struct PhongData {
    Rgb diffuse, specular;
    float exponent = 0;
    bool normalized = true;
    bool attenuates = false;
    double a = 0, b = 0, c = 1;          ///< 1/(a + b d + c d^2)
    DirectionalTable<float> lobe_share;  ///< of the normalised lobe with ks = 1 that is above the surface
};

/// Directional albedo of the lobe (n + 2)/(2 pi) cos^n alpha with its axis at cos_axis from the normal. Around the axis
/// the integral of max(0, cosine) is closed, so that one integral over u = cos^(n+1) alpha is left.
double lobe_albedo(double cos_axis, double exponent) {
    constexpr int steps = 512;
    const double sin_axis = std::sqrt(std::max(0.0, 1 - cos_axis * cos_axis));
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double cos_alpha = std::pow((i + 0.5) / steps, 1 / (exponent + 1));
        const double m = cos_alpha * cos_axis, w = std::sqrt(1 - cos_alpha * cos_alpha) * sin_axis;
        if (m >= w) {
            sum += m;
        } else if (m > -w) {
            const double phi = std::acos(-m / w);
            sum += (m * phi + w * std::sin(phi)) * std::numbers::inv_pi;
        }
    }
    return (exponent + 2) / (exponent + 1) * sum / steps;
}

class PhongBsdf final : public Bsdf {
public:
    explicit PhongBsdf(const PhongData& data) : data_(&data) {}

    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse | Lobe::glossy; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override { return f(wo, wi, Lobe::all); }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override {
        if (wo.z * wi.z <= 0) return 0;
        const LobeChoice p = choice(wo, which);
        const float n = data_->exponent;
        const float lobe = p.second > 0 ? (n + 1) / (2 * pi) * cos_power(wo, wi) : 0;
        return p.first * std::abs(wi.z) * inv_pi + p.second * lobe;
    }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float u_lobe, Vec2 u, Lobe which) const noexcept override {
        const LobeChoice p = choice(wo, which);
        if (p.none() || wo.z == 0) return {};
        const bool diffuse = u_lobe < p.first;
        Vec3 wi;
        if (diffuse) {
            wi = sample_cosine_hemisphere(u);
            if (wo.z < 0) wi = flip_z(wi);
        } else {
            wi = sample_lobe({-wo.x, -wo.y, wo.z}, u);
        }
        const float density = pdf(wo, wi, which);
        if (!(density > 0)) return {};
        return {wi, f(wo, wi, which) * (std::abs(wi.z) / density), density, diffuse ? Lobe::diffuse : Lobe::glossy};
    }
    [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept override {
        const float share = data_->normalized ? data_->lobe_share(std::abs(wo.z)) : 1;
        return {.diffuse = data_->diffuse, .specular = data_->specular * share};
    }
    [[nodiscard]] float attenuation(double distance) const noexcept override {
        if (!data_->attenuates || !std::isfinite(distance)) return 1;
        const double d2 = distance * distance, divisor = data_->a + data_->b * distance + data_->c * d2;
        return divisor > 0 ? static_cast<float>(d2 / divisor) : 1;
    }

private:
    /// cos^n of the angle between wi and the mirrored wo. From the chord: cosines of small angles have no digits left
    /// for large exponents.
    [[nodiscard]] float cos_power(Vec3 wo, Vec3 wi) const noexcept {
        const Vec3 chord = wi - Vec3{-wo.x, -wo.y, wo.z};
        const float one_minus_cos = dot(chord, chord) / 2;
        return one_minus_cos < 1 ? std::exp(data_->exponent * std::log1p(-one_minus_cos)) : 0;
    }
    [[nodiscard]] Vec3 sample_lobe(Vec3 axis, Vec2 u) const noexcept {
        const float one_minus_cos = -std::expm1(std::log(u.x) / (data_->exponent + 1));
        const float r = std::sqrt(std::max(0.0F, one_minus_cos * (2 - one_minus_cos)));
        return Frame(axis).to_world({r * std::cos(2 * pi * u.y), r * std::sin(2 * pi * u.y), 1 - one_minus_cos});
    }
    [[nodiscard]] LobeChoice choice(Vec3 wo, Lobe which) const noexcept {
        const Albedo a = albedo(wo);
        return {within(Lobe::diffuse, which) ? average(a.diffuse) : 0,
                within(Lobe::glossy, which) ? average(a.specular) : 0};
    }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi, Lobe which) const noexcept {
        if (wo.z * wi.z <= 0) return {};
        Rgb sum;
        if (within(Lobe::diffuse, which)) sum += data_->diffuse * (data_->normalized ? inv_pi : 1);
        if (within(Lobe::glossy, which))
            sum += data_->specular * (cos_power(wo, wi) * (data_->normalized ? (data_->exponent + 2) / (2 * pi)
                                                                             : 1 / std::max(std::abs(wi.z), 1e-6F)));
        return sum;
    }

    const PhongData* data_;
};

class PhongShader final : public Shader {
public:
    explicit PhongShader(const PhongData& data) : data_(data) {}
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept override {
        return memory.make<PhongBsdf>(data_);
    }

private:
    PhongData data_;
};

constexpr ParamSpec params[] = {
    {"diffuse", ParamType::colour, "0.5", "diffuse share, per channel, 0 to 1"},
    {"specular", ParamType::colour, "0.2", "shiny share, per channel; diffuse + specular at most 1"},
    {"exponent", ParamType::number, "20", "sharpness of the highlight, 0 to 1e6"},
    {"normalized", ParamType::boolean, "true", "false: equation 7 of ARL-TR-3608, which does not conserve energy"},
    {"attenuation", ParamType::vector, "[0, 0, 1]", "[a, b, c]: direct light falls off as 1/(a + b d + c d^2)"},
    {"attenuation_p", ParamType::number, "0", "p [unit^2]: direct light falls off as 1/(p + d^2)"}};

void read_attenuation(const Params& in, PhongData& data) {
    if (const auto abc = in.vector("attenuation", 3)) {
        if (in.has("attenuation_p")) in.wrong("attenuation_p", "left out where attenuation is given");
        data.a = (*abc)[0], data.b = (*abc)[1], data.c = (*abc)[2];
        if (std::min({data.a, data.b, data.c}) < 0 || data.a + data.b + data.c <= 0)
            in.wrong("attenuation", "[a, b, c], none negative, not all 0");
    } else {
        data.a = in.number("attenuation_p", 0, 0);
    }
    data.attenuates = data.a != 0 || data.b != 0 || data.c != 1;
}

std::shared_ptr<const Shader> make(const ShaderInputs& in) {
    PhongData data;
    data.diffuse = in.params.colour("diffuse", Rgb(0.5F), 0, 1);
    data.specular = in.params.colour("specular", Rgb(0.2F), 0, 1);
    if (max_component(data.diffuse + data.specular) > 1 + 1e-5F)
        in.params.wrong(in.params.has("specular") ? "specular" : "diffuse",
                        "smaller: diffuse + specular must be at most 1 in every channel");
    data.exponent = static_cast<float>(in.params.number("exponent", 20, 0, 1e6));
    data.normalized = in.params.boolean("normalized", true);
    data.lobe_share =
        DirectionalTable<float>([&](double c) { return static_cast<float>(lobe_albedo(c, double{data.exponent})); });
    read_attenuation(in.params, data);
    return std::make_shared<PhongShader>(data);
}

}  // namespace

const ShaderKind phong_kind{"phong", "diffuse and shiny share (Phong, energy-normalised)", params, make};

}  // namespace cardioid::shaders

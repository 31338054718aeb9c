/// `plastic`: a coloured diffuse body under a clear coat.
///
///     define_material("toy", kind = "plastic", reflectance = [0.7, 0.05, 0.05], roughness = 0.2)
///
/// | parameter     | default | |
/// |---------------|---------|---|
/// | `reflectance` | 0.5     | albedo of the body per channel, 0 to 1 |
/// | `ior`         | 1.5     | index of the coat, 1 to 4 |
/// | `roughness`   | 0       | of the coat, 0 (mirror-smooth) to 1; GGX with alpha = roughness^2 |
///
/// The coat reflects E(theta) (Fresnel, or its mean over the facets). The rest enters, is scattered by the body, and
/// leaves after any number of inner reflections Ei, the share that diffuse light meets from inside:
///     f = f_coat + (1 - E(theta_i)) (1 - E(theta_o)) reflectance / (pi ior^2 (1 - reflectance Ei)),
///     1 - Ei = (1 - mean E) / ior^2
/// (Wolff 1994; Ashikhmin, Shirley 2000). Reciprocal; a white body reflects exactly all light.
#include "shaders/materials/lobes.hpp"
#include "shaders/materials/materials.hpp"
#include "shaders/optics/directional_table.hpp"
#include "shaders/optics/fresnel.hpp"
#include "shaders/optics/ggx.hpp"

namespace cardioid::shaders {
namespace {

struct PlasticData {
    double ior = 1.5;
    Ggx ggx{0};                    ///< alpha 0: smooth
    DirectionalTable<float> coat;  ///< E over the cosine, rough coats only
    Rgb body;                      ///< reflectance / (pi ior^2 (1 - reflectance Ei))
    float entering = 1;            ///< 1 - mean E

    [[nodiscard]] bool smooth() const { return ggx.alpha <= 0; }
    [[nodiscard]] float coat_reflectance(float cosine) const {
        return smooth() ? static_cast<float>(fresnel_dielectric(double{cosine}, ior)) : coat(cosine);
    }
    [[nodiscard]] Lobe coat_lobe() const { return smooth() ? Lobe::specular : Lobe::glossy; }
};

class PlasticBsdf final : public Bsdf {
public:
    explicit PlasticBsdf(const PlasticData& data) : data_(&data) {}

    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse | data_->coat_lobe(); }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override { return f(wo, wi, Lobe::all); }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override {
        if (wo.z * wi.z <= 0) return 0;
        const LobeChoice p = choice(wo, which);
        float density = p.first * std::abs(wi.z) * inv_pi;
        if (p.second > 0 && !data_->smooth()) {
            const Vec3 o = upper(wo), h = half_vector(o, upper(wi));
            density += p.second * data_->ggx.density(h) * data_->ggx.masking_over_2z(o) / 2;
        }
        return density;
    }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float u_lobe, Vec2 u, Lobe which) const noexcept override {
        const LobeChoice p = choice(wo, which);
        if (p.none() || wo.z == 0) return {};
        const bool diffuse = u_lobe < p.first;
        if (!diffuse && data_->smooth()) {
            const float r = data_->coat_reflectance(std::abs(wo.z));
            return {{-wo.x, -wo.y, wo.z}, Rgb(r / p.second), 0, Lobe::specular};
        }
        const Vec3 o = upper(wo);
        Vec3 wi = diffuse ? sample_cosine_hemisphere(u) : reflect(o, data_->ggx.sample_visible(o, u));
        if (wi.z <= 0) return {};
        if (wo.z < 0) wi = flip_z(wi);
        const float density = pdf(wo, wi, which);
        if (!(density > 0)) return {};
        return {wi, f(wo, wi, which) * (std::abs(wi.z) / density), density, diffuse ? Lobe::diffuse : Lobe::glossy};
    }
    [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept override {
        const float r = data_->coat_reflectance(std::abs(wo.z));
        return {.diffuse = data_->body * (pi * (1 - r) * data_->entering), .specular = Rgb(r)};
    }
    /// Grazing light is turned away by the coat.
    [[nodiscard]] float diffuse_acceptance(Vec3 wi) const noexcept override {
        return (1 - data_->coat_reflectance(std::abs(wi.z))) / data_->entering;
    }

private:
    static Vec3 upper(Vec3 w) { return {w.x, w.y, std::abs(w.z)}; }
    [[nodiscard]] LobeChoice choice(Vec3 wo, Lobe which) const noexcept {
        const Albedo a = albedo(wo);
        return {within(Lobe::diffuse, which) ? average(a.diffuse) : 0,
                within(data_->coat_lobe(), which) ? a.specular.r : 0};
    }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi, Lobe which) const noexcept {
        if (wo.z * wi.z <= 0) return {};
        const Vec3 o = upper(wo), i = upper(wi);
        Rgb sum;
        if (within(Lobe::diffuse, which))
            sum += data_->body * ((1 - data_->coat_reflectance(o.z)) * (1 - data_->coat_reflectance(i.z)));
        if (within(Lobe::glossy, which) && !data_->smooth()) {
            const Vec3 h = half_vector(o, i);
            const auto r = static_cast<float>(fresnel_dielectric(double{dot(o, h)}, data_->ior));
            sum += Rgb(r * data_->ggx.density(h) * data_->ggx.shadowing_over_4zz(o, i));
        }
        return sum;
    }

    const PlasticData* data_;
};

class PlasticShader final : public Shader {
public:
    PlasticShader(Rgb reflectance, double ior, float alpha) {
        data_.ior = ior;
        data_.ggx.alpha = alpha;
        if (!data_.smooth())
            data_.coat = DirectionalTable<float>([&](double c) {
                return rough_reflectance<float>(data_.ggx, c, [&](float facet_cosine) {
                    return static_cast<float>(fresnel_dielectric(double{facet_cosine}, ior));
                });
            });
        const double outside =
            diffuse_average([&](double c) { return double{data_.coat_reflectance(static_cast<float>(c))}; });
        const double inside = diffuse_fresnel_inside(outside, ior);
        const auto body = [&](float r) {
            return static_cast<float>(double{r} / (std::numbers::pi * ior * ior * (1 - double{r} * inside)));
        };
        data_.body = {body(reflectance.r), body(reflectance.g), body(reflectance.b)};
        data_.entering = static_cast<float>(1 - outside);
    }
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept override {
        return memory.make<PlasticBsdf>(data_);
    }

private:
    PlasticData data_;
};

constexpr ParamSpec params[] = {
    {"reflectance", ParamType::colour, "0.5", "albedo of the body under the coat, per channel, 0 to 1"},
    {"ior", ParamType::number, "1.5", "index of refraction of the coat, 1 to 4"},
    {"roughness", ParamType::number, "0", "of the coat, 0 (smooth) to 1"}};

std::shared_ptr<const Shader> make(const ShaderInputs& in) {
    return std::make_shared<PlasticShader>(in.params.colour("reflectance", Rgb(0.5F), 0, 1),
                                           in.params.number("ior", 1.5, 1, 4),
                                           Ggx::alpha_of(in.params.number("roughness", 0, 0, 1)));
}

}  // namespace

const ShaderKind plastic_kind{"plastic", "diffuse body under a clear coat, smooth or rough", params, make};

}  // namespace cardioid::shaders

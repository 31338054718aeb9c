/// `diffuse`: paper, plaster, matt paint (Lambert 1760). Looks equally bright from everywhere.
///
///     define_material("wall", kind = "diffuse", reflectance = [0.8, 0.8, 0.7])
///
/// | parameter     | default | |
/// |---------------|---------|---|
/// | `reflectance` | 0.5     | albedo per channel, 0 to 1 |
///
/// f = reflectance / pi where wo and wi are on one side of the surface, sampled with pdf cos / pi.
#include "shaders/materials/diffuse.hpp"

#include "shaders/materials/lobes.hpp"
#include "shaders/materials/materials.hpp"

namespace cardioid::shaders {
namespace {

class DiffuseBsdf final : public Bsdf {
public:
    explicit DiffuseBsdf(Rgb reflectance) : reflectance_(reflectance) {}

    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override {
        return wo.z * wi.z > 0 ? reflectance_ * inv_pi : Rgb{};
    }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override {
        return wo.z * wi.z > 0 && within(Lobe::diffuse, which) ? std::abs(wi.z) * inv_pi : 0;
    }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float, Vec2 u, Lobe which) const noexcept override {
        if (!within(Lobe::diffuse, which) || wo.z == 0) return {};
        Vec3 wi = sample_cosine_hemisphere(u);
        if (wi.z <= 0) return {};
        if (wo.z < 0) wi = flip_z(wi);
        return {wi, reflectance_, std::abs(wi.z) * inv_pi, Lobe::diffuse};
    }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return {.diffuse = reflectance_}; }

private:
    Rgb reflectance_;
};

constexpr ParamSpec params[] = {
    {"reflectance", ParamType::colour, "0.5", "share of light that is reflected, per channel, 0 to 1"}};

std::shared_ptr<const Shader> make(const ShaderInputs& in) {
    return std::make_shared<DiffuseShader>(in.params.colour("reflectance", Rgb(0.5F), 0, 1));
}

}  // namespace

const Bsdf* DiffuseShader::bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept {
    return memory.make<DiffuseBsdf>(reflectance_);
}

const ShaderKind diffuse_kind{"diffuse", "matt surface that scatters light evenly (Lambert)", params, make};

}  // namespace cardioid::shaders

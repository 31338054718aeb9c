/// `mirror`: a perfect mirror of one colour, on both sides.
///
///     define_material("looking glass", kind = "mirror", reflectance = 0.95)
///
/// | parameter     | default | |
/// |---------------|---------|---|
/// | `reflectance` | 1       | share of light reflected per channel, 0 to 1, the same at every angle |
///
/// For the colour and the angles of a real metal take `conductor`.
#include "shaders/materials/lobes.hpp"
#include "shaders/materials/materials.hpp"

namespace cardioid::shaders {
namespace {

class MirrorBsdf final : public Bsdf {
public:
    explicit MirrorBsdf(Rgb reflectance) : reflectance_(reflectance) {}

    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::specular; }
    [[nodiscard]] Rgb f(Vec3, Vec3) const noexcept override { return {}; }
    [[nodiscard]] float pdf(Vec3, Vec3, Lobe) const noexcept override { return 0; }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float, Vec2, Lobe which) const noexcept override {
        if (!within(Lobe::specular, which) || wo.z == 0) return {};
        return {{-wo.x, -wo.y, wo.z}, reflectance_, 0, Lobe::specular};
    }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return {.specular = reflectance_}; }

private:
    Rgb reflectance_;
};

class MirrorShader final : public Shader {
public:
    explicit MirrorShader(Rgb reflectance) : reflectance_(reflectance) {}
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept override {
        return memory.make<MirrorBsdf>(reflectance_);
    }

private:
    Rgb reflectance_;
};

constexpr ParamSpec params[] = {
    {"reflectance", ParamType::colour, "1", "share of light that is reflected, per channel, 0 to 1"}};

std::shared_ptr<const Shader> make(const ShaderInputs& in) {
    return std::make_shared<MirrorShader>(in.params.colour("reflectance", Rgb(1), 0, 1));
}

}  // namespace

const ShaderKind mirror_kind{"mirror", "perfect mirror", params, make};

}  // namespace cardioid::shaders

/// `emitter`: gives light and reflects none.
///
///     define_material("tube", kind = "emitter", emission = [10, 10, 9])
///
/// Its one parameter, `emission`, is common to every kind of material: radiance [W/(sr unit^2)] that leaves the outer
/// side of the surface (default [0, 0, 0]).
#include "shaders/materials/materials.hpp"

namespace cardioid::shaders {
namespace {

class BlackBsdf final : public Bsdf {
public:
    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::none; }
    [[nodiscard]] Rgb f(Vec3, Vec3) const noexcept override { return {}; }
    [[nodiscard]] float pdf(Vec3, Vec3, Lobe) const noexcept override { return 0; }
    [[nodiscard]] BsdfSample sample(Vec3, float, Vec2, Lobe) const noexcept override { return {}; }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return {}; }
};

class EmitterShader final : public Shader {
public:
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept override {
        return memory.make<BlackBsdf>();
    }
};

std::shared_ptr<const Shader> make(const ShaderInputs&) { return std::make_shared<EmitterShader>(); }

}  // namespace

const ShaderKind emitter_kind{"emitter", "black surface that gives light by its `emission`", {}, make};

}  // namespace cardioid::shaders

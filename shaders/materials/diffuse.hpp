#pragma once
#include "rt_core/api/shader.hpp"

namespace cardioid::shaders {

/// Lambert's reflector; each side of the surface reflects on its own side.
class DiffuseShader final : public Shader {
public:
    /// reflectance: albedo per channel in [0, 1].
    explicit DiffuseShader(Rgb reflectance) : reflectance_(reflectance) {}
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint& hit, BsdfMemory& memory) const noexcept override;

private:
    Rgb reflectance_;
};

}  // namespace cardioid::shaders

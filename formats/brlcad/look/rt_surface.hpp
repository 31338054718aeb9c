#pragma once
#include <memory>

#include "formats/brlcad/look/rt_texture.hpp"
#include "formats/brlcad/look/uv_chart.hpp"
#include "rt_core/api/shader.hpp"

namespace cardioid::formats::brlcad {

/// A surface in the terms of BRL-CAD's rt (sh_plastic.c, sh_light.c). Colours are display values.
struct RtFinish {
    Rgb colour{1};
    float shine = 10, specular = 0.7F, diffuse = 0.3F, transmit = 0, reflect = 0, index = 1;
    bool flat = false;                         ///< the colour as it is, without light: a texture
    bool around = false;                       ///< this is what rays see that meet nothing: an envmap
    float light = 0;                           ///< weight of the light this region is; 0 where it is none
    bool shadows = true;                       ///< of that light
    float beam_cosine = -1;                    ///< of that light: of the angle around straight down that it shines into
    Vec3d place;                               ///< of that light
    std::shared_ptr<const RtTexture> texture;  ///< in place of the colour; may be null
    UvChart chart;                             ///< of the primitive that the surface is on

    /// Of the surface at the world point p with the normal n.
    [[nodiscard]] Rgb colour_at(Vec3d p, Vec3 n) const noexcept {
        return texture ? texture->at(chart.at(p, n)) : colour;
    }
};

class RtSurface final : public Shader {
public:
    explicit RtSurface(const RtFinish& finish) : finish_(finish) {}
    [[nodiscard]] const RtFinish& finish() const noexcept { return finish_; }
    /// Matt, for modules that know nothing of rt.
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept override;

private:
    RtFinish finish_;
};

/// `rt_surface`, which the lighting `rt` draws.
extern const ShaderKind rt_surface_kind;

}  // namespace cardioid::formats::brlcad

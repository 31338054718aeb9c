/// `rt_surface`: a surface of BRL-CAD's rt, made by `--set brlcad.look=rt` and drawn by `--lighting rt`.
#include "formats/brlcad/look/rt_surface.hpp"

#include <cmath>

#include "rt_core/math/sampling.hpp"

namespace cardioid::formats::brlcad {

namespace {

class MattBsdf final : public Bsdf {
public:
    explicit MattBsdf(Rgb colour) : colour_(colour) {}
    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override { return wo.z * wi.z > 0 ? colour_ * inv_pi : Rgb{}; }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override {
        return wo.z * wi.z > 0 && any(which & Lobe::diffuse) ? std::abs(wi.z) * inv_pi : 0;
    }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float, Vec2 u, Lobe which) const noexcept override {
        Vec3 wi = sample_cosine_hemisphere(u);
        if (!any(which & Lobe::diffuse) || wo.z == 0 || wi.z <= 0) return {};
        if (wo.z < 0) wi.z = -wi.z;
        return {wi, colour_, std::abs(wi.z) * inv_pi, Lobe::diffuse};
    }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return {.diffuse = colour_}; }

private:
    Rgb colour_;
};

constexpr ParamSpec params[] = {
    {"colour", ParamType::colour, "1", "of the region, as a display has it, 0 to 1"},
    {"shine", ParamType::number, "10", "sharpness of the highlight"},
    {"specular", ParamType::number, "0.7", "share of the highlight"},
    {"diffuse", ParamType::number, "0.3", "share of the light from lamps"},
    {"transmit", ParamType::number, "0", "share that goes through, 0 to 1"},
    {"reflect", ParamType::number, "0", "share that is mirrored, 0 to 1"},
    {"index", ParamType::number, "1", "of refraction; 0 bends nothing"},
    {"flat", ParamType::number, "0", "1: the colour as it is, without light"},
    {"angle", ParamType::number, "180", "degrees around straight down that the light shines into"},
    {"light", ParamType::number, "0", "weight of the light this region is"},
    {"shadows", ParamType::number, "1", "0: that light has none"},
    {"place", ParamType::vector, "[0, 0, 0]", "where that light is"}};

std::shared_ptr<const Shader> make(const ShaderInputs& in) {
    const auto number = [&](const char* name, double fallback, double most) {
        return static_cast<float>(in.params.number(name, fallback, 0, most));
    };
    RtFinish finish;
    finish.colour = in.params.colour("colour", Rgb(1), 0, 1);
    finish.shine = number("shine", 10, 1e6);
    finish.specular = number("specular", 0.7, 100);
    finish.diffuse = number("diffuse", 0.3, 100);
    finish.transmit = number("transmit", 0, 1);
    finish.reflect = number("reflect", 0, 1);
    finish.index = number("index", 1, 10);
    finish.flat = number("flat", 0, 1) > 0;
    finish.beam_cosine = std::cos(number("angle", 180, 180) * (pi / 180));
    finish.light = number("light", 0, 1e6);
    finish.shadows = number("shadows", 1, 1) > 0;
    if (const auto p = in.params.vector("place", 3)) finish.place = {(*p)[0], (*p)[1], (*p)[2]};
    return std::make_shared<RtSurface>(finish);
}

}  // namespace

const Bsdf* RtSurface::bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept {
    return memory.make<MattBsdf>(finish_.colour * 0.8F);
}

const ShaderKind rt_surface_kind{"rt_surface", "surface of BRL-CAD's rt, for comparing with it", params, make};

}  // namespace cardioid::formats::brlcad

/// `dielectric`: glass, water, gems: reflects and bends light by Fresnel's and Snell's laws.
///
///     define_material("bottle", kind = "dielectric", ior = 1.52, transmittance = [0.5, 0.9, 0.6], distance = 10)
///
/// | parameter       | default | |
/// |-----------------|---------|---|
/// | `ior`           | 1.5     | index of refraction, 1 to 10 |
/// | `absorption`    | 0       | per unit of length and channel: exp(-absorption d) is left after d (Beer, Lambert) |
/// | `transmittance` | 1       | instead of absorption: what is left after `distance`, per channel, above 0, at most 1
/// | | `distance`      | 1       | scene units, above 0 | | `roughness`     | 0       | 0 (smooth) to 1; GGX with alpha
/// = roughness^2 | | `priority`      | 0       | whole number; where solids overlap, the higher fills the place |
/// | `straight_shadows` | false | true: shadow rays pass unbent and whole, as POV-Ray has it; wrong, for comparing |
///
/// Smooth: unpolarised Fresnel reflectance R, total internal reflection included; the rest goes on by Snell's law.
/// Rough: facets of that kind (Walter et al. 2007). The indices on the two sides are those of the media that really
/// meet at the point, so that liquid in a bottle and overlapping solids come out right. Where both are equal light
/// goes straight through. Radiance along wo is (eta_o / eta_i)^2 times what came along wi; albedo() counts light,
/// without that factor.
#include <cmath>
#include <optional>

#include "shaders/materials/dielectric_bsdf.hpp"
#include "shaders/materials/materials.hpp"

namespace cardioid::shaders {
namespace {

class DielectricShader final : public Shader {
public:
    DielectricShader(const Medium& medium, float alpha, bool straight_shadows)
        : medium_(medium), straight_shadows_(straight_shadows) {
        if (alpha > 0) rough_.emplace(alpha, medium.ior);
    }
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint& hit, BsdfMemory& memory) const noexcept override {
        const Boundary boundary{hit.front ? hit.front->ior : 1, hit.back ? hit.back->ior : medium_.ior};
        // Facets between equal media bend nothing; their half vectors would be rounding errors.
        const bool bends = std::abs(boundary.eta_front - boundary.eta_back) > 1e-4F * boundary.eta_front;
        if (rough_ && bends) return memory.make<RoughDielectricBsdf>(*rough_, boundary);
        return memory.make<SmoothDielectricBsdf>(boundary);
    }
    [[nodiscard]] const Medium* interior() const noexcept override { return &medium_; }
    [[nodiscard]] Rgb straight_transmittance(const SurfacePoint&, Vec3) const noexcept override {
        return Rgb(straight_shadows_ ? 1.0F : 0.0F);
    }
    [[nodiscard]] bool filters() const noexcept override { return straight_shadows_; }

private:
    Medium medium_;
    bool straight_shadows_;
    std::optional<RoughDielectricData> rough_;
};

constexpr ParamSpec params[] = {
    {"ior", ParamType::number, "1.5", "index of refraction, 1 to 10"},
    {"absorption", ParamType::colour, "0", "per scene unit and channel: exp(-absorption d) is left after d"},
    {"transmittance", ParamType::colour, "1",
     "instead of absorption: what is left after `distance`, above 0, at most 1"},
    {"distance", ParamType::number, "1", "for transmittance [scene units], above 0"},
    {"roughness", ParamType::number, "0", "0 (smooth) to 1"},
    {"priority", ParamType::number, "0", "whole number: where solids overlap, the higher fills the place"},
    {"straight_shadows", ParamType::boolean, "false", "true: shadow rays pass unbent and whole, as in POV-Ray"}};

Rgb read_absorption(const Params& in) {
    if (!in.has("transmittance")) {
        if (in.has("distance")) in.wrong("distance", "given together with transmittance");
        return in.colour("absorption", {});
    }
    if (in.has("absorption")) in.wrong("absorption", "left out where transmittance is given");
    const Rgb t = in.colour("transmittance", Rgb(1), 0, 1);
    const double distance = in.number("distance", 1, 0);
    if (min_component(t) <= 0) in.wrong("transmittance", "above 0 in every channel");
    if (distance <= 0) in.wrong("distance", "above 0");
    const auto channel = [&](float x) { return static_cast<float>(-std::log(double{x}) / distance) + 0.0F; };
    return {channel(t.r), channel(t.g), channel(t.b)};
}

std::shared_ptr<const Shader> make(const ShaderInputs& in) {
    Medium medium;
    medium.ior = static_cast<float>(in.params.number("ior", 1.5, 1, 10));
    medium.absorption = read_absorption(in.params);
    const double priority = in.params.number("priority", 0, -1e6, 1e6);
    if (priority != std::floor(priority)) in.params.wrong("priority", "a whole number");
    medium.priority = static_cast<int>(priority);
    return std::make_shared<DielectricShader>(medium, Ggx::alpha_of(in.params.number("roughness", 0, 0, 1)),
                                              in.params.boolean("straight_shadows", false));
}

}  // namespace

const ShaderKind dielectric_kind{"dielectric", "glass, water, gems: reflects and bends light", params, make};

}  // namespace cardioid::shaders

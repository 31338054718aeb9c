/// `velvet`: cloth with a bright rim, as a Cardioid plug-in. All of it is in this file.
///
///     define_material("curtain", kind = "velvet", reflectance = [0.3, 0.01, 0.02], sheen = [0.9, 0.3, 0.3])
///
/// f = (1 - s) reflectance / pi + sheen (k+1)(k+2)/(2 pi) (1-cos wo)^k (1-cos wi)^k, with s the brightest channel of
/// sheen and k the sharpness. The rim's share of light is sheen (1-cos wo)^k exactly, so that no more light leaves the
/// cloth than falls on it; f does not change when wo and wi are exchanged.
#include <cmath>
#include <memory>

#include "rt_core/api/plugin.h"
#include "rt_core/api/registry.hpp"

namespace {

using namespace cardioid;

class VelvetBsdf final : public Bsdf {
public:
    VelvetBsdf(Rgb base, Rgb sheen, float sharpness) : base_(base), sheen_(sheen), k_(sharpness) {}

    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override {
        if (wo.z * wi.z <= 0) return {};
        return base_ * inv_pi + sheen_ * ((k_ + 1) * (k_ + 2) * inv_pi / 2 * rim(wo) * rim(wi));
    }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override {
        if (wo.z * wi.z <= 0 || !any(which & Lobe::diffuse)) return 0;
        return 0.5F * (std::abs(wi.z) + (k_ + 1) / 2 * rim(wi)) * inv_pi;
    }
    /// Half the directions by the cosine, half towards the rim: 1 - cos = u^(1/(k+1)) has density (k+1)(1-cos)^k.
    [[nodiscard]] BsdfSample sample(Vec3 wo, float u_lobe, Vec2 u, Lobe which) const noexcept override {
        if (!any(which & Lobe::diffuse)) return {};
        Vec3 wi = sample_cosine_hemisphere(u);
        if (u_lobe < 0.5F) {
            const float z = 1 - std::pow(u.x, 1 / (k_ + 1)), r = std::sqrt(std::max(0.0F, 1 - z * z));
            wi = {r * std::cos(2 * pi * u.y), r * std::sin(2 * pi * u.y), z};
        }
        if (wo.z < 0) wi.z = -wi.z;
        const float density = pdf(wo, wi, which);
        if (!(density > 0)) return {};
        return {wi, f(wo, wi) * (std::abs(wi.z) / density), density, Lobe::diffuse};
    }
    [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept override { return {.diffuse = base_ + sheen_ * rim(wo)}; }

private:
    [[nodiscard]] float rim(Vec3 w) const noexcept { return std::pow(1 - std::min(std::abs(w.z), 1.0F), k_); }

    Rgb base_, sheen_;
    float k_;
};

class Velvet final : public Shader {
public:
    explicit Velvet(const Params& params)
        : sheen_(params.colour("sheen", Rgb(0.5F), 0, 1)),
          base_(params.colour("reflectance", Rgb(0.1F), 0, 1) * (1 - max_component(sheen_))),
          sharpness_(static_cast<float>(params.number("sharpness", 4, 0, 100))) {}

    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept override {
        return memory.make<VelvetBsdf>(base_, sheen_, sharpness_);
    }

private:
    Rgb sheen_, base_;
    float sharpness_;
};

constexpr ParamSpec params[] = {
    {"reflectance", ParamType::colour, "0.1", "albedo of the cloth seen from above, 0 to 1"},
    {"sheen", ParamType::colour, "0.5", "albedo of its rim, 0 to 1"},
    {"sharpness", ParamType::number, "4", "how narrow the rim is, 0 to 100"}};

std::shared_ptr<const Shader> make(const ShaderInputs& in) { return std::make_shared<Velvet>(in.params); }

/// Nothing may be thrown through the C interface; what went wrong is logged.
int attach(const CardioidHost* host) {
    try {
        host->registry->add(ShaderKind{"velvet", "cloth with a bright rim", params, make});
        return CARDIOID_OK;
    } catch (const std::exception& error) {
        host->log(error.what());
        return CARDIOID_FAILED;
    }
}

constexpr CardioidPlugin plugin{
    sizeof(CardioidPlugin), CARDIOID_ABI_MAJOR, CARDIOID_ABI_MINOR, "velvet", "1.0", attach};

}  // namespace

extern "C" const CardioidPlugin* cardioid_plugin_query() { return &plugin; }

#include "rt_core/render/lighting/path_lighting.hpp"

#include <limits>

#include "rt_core/render/lighting/light_path.hpp"

namespace cardioid {

namespace {

class PathLighting final : public LightingModule {
public:
    explicit PathLighting(const PathSettings& settings) : settings_(settings) {}

    void prepare(const World& world, const Eye*, Progress&) override {
        next_event_.emplace(world);
        choice_.emplace(world);
    }
    [[nodiscard]] Rgb indirect(const World& world, const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo,
                               Sampler& sampler) const noexcept override {
        return walk(world, sampler).from_point(point, bsdf, wo, false).indirect;
    }
    [[nodiscard]] Rgb caustic(const World& world, const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo,
                              Sampler& sampler) const noexcept override {
        return walk(world, sampler).from_point(point, bsdf, wo, true).caustic;
    }
    [[nodiscard]] std::optional<LightParts> incoming(const World& world, const EyeRay& eye,
                                                     Sampler& sampler) const noexcept override {
        return walk(world, sampler).from_eye(eye);
    }

private:
    [[nodiscard]] LightPath walk(const World& world, Sampler& sampler) const noexcept {
        return {world, *next_event_, *choice_, settings_, sampler};
    }

    PathSettings settings_;
    std::optional<NextEvent> next_event_;
    std::optional<LightChoice> choice_;
};

constexpr int no_limit = std::numeric_limits<int>::max();

constexpr ParamSpec path_params[] = {
    {"depth", ParamType::number, "",
     "surfaces between light and eye: 0 is light itself, 1 direct light; else no limit"}};

std::unique_ptr<LightingModule> make(const Params& params, std::uint32_t) {
    const double depth = params.number("depth", no_limit, 0, no_limit);
    if (depth != std::floor(depth)) params.wrong("depth", "a whole number");
    return std::make_unique<PathLighting>(PathSettings{static_cast<int>(depth)});
}

}  // namespace

const LightingKind path_lighting{"path", "every way of light, unbiased and slow: the reference", path_params, make};

}  // namespace cardioid

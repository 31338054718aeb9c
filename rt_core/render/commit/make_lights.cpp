#include "rt_core/render/commit/make_lights.hpp"

#include <numbers>
#include <string_view>

#include "rt_core/scene/nearest_name.hpp"

namespace cardioid {

namespace {

/// The key light stands 45 degrees left of the default view (azimuth 35) and high; angles in degrees.
constexpr double key_azimuth = -10, key_elevation = 50, key_angle = 10;
/// With the studio sky a facing surface of reflectance 1 comes out just below white.
constexpr double key_irradiance = 1.95;

const LightKind* find(const Registry& registry, std::string_view name) {
    for (const LightKind& kind : registry.lights())
        if (kind.name == name) return &kind;
    return nullptr;
}

const LightKind& kind_of(const LightSettings& settings, const Registry& registry) {
    std::string_view wanted = settings.kind;
    constexpr std::string_view plugin = "plugin:";
    if (wanted.starts_with(plugin)) wanted.remove_prefix(plugin.size());
    if (const LightKind* kind = find(registry, wanted)) return *kind;
    std::vector<std::string_view> names;
    for (const LightKind& kind : registry.lights()) names.emplace_back(kind.name);
    throw Error(ErrorCode::bad_input,
                settings.params.where() + ": no light \"" + std::string(wanted) + "\"" + did_you_mean(wanted, names));
}

}  // namespace

std::vector<std::unique_ptr<Light>> make_lights(const Scene& scene, const Registry& registry) {
    std::vector<std::unique_ptr<Light>> lights;
    for (const LightSettings& settings : scene.lights)
        lights.push_back(kind_of(settings, registry).make({settings.params, settings.to_world, scene.base_dir}));
    return lights;
}

std::vector<LightSettings> studio_lights(const Registry& registry) {
    std::vector<LightSettings> lights;
    if (find(registry, "sun")) {
        LightSettings key{"sun", Params("studio"), {}};
        constexpr double degree = std::numbers::pi / 180;
        const double up = std::sin(key_elevation * degree), flat = std::cos(key_elevation * degree);
        key.params.set("direction", ParamValue{.numbers = {-flat * std::cos(key_azimuth * degree),
                                                           -flat * std::sin(key_azimuth * degree), -up},
                                               .list = true});
        key.params.set("irradiance", key_irradiance);
        key.params.set("angle", key_angle);
        lights.push_back(std::move(key));
    }
    if (find(registry, "sky")) {
        LightSettings sky{"sky", Params("studio"), {}};
        sky.params.set("radiance", std::string("studio"));
        lights.push_back(std::move(sky));
    }
    return lights;
}

}  // namespace cardioid

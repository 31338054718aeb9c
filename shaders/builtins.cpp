#include "shaders/builtins.hpp"

#include "shaders/lights/lights.hpp"
#include "shaders/materials/materials.hpp"

namespace cardioid::shaders {

std::span<const ShaderKind> builtin_shaders() {
    static const ShaderKind kinds[] = {diffuse_kind,    phong_kind,   plastic_kind, mirror_kind, conductor_kind,
                                       dielectric_kind, emitter_kind, checker_kind, filter_kind, pov_finish_kind};
    return kinds;
}

std::span<const LightKind> builtin_lights() {
    static const LightKind kinds[] = {point_light_kind,  spot_light_kind, area_light_kind, disk_light_kind,
                                      sphere_light_kind, sun_kind,        sky_kind};
    return kinds;
}

void add_builtins(Registry& registry) {
    for (const ShaderKind& kind : builtin_shaders()) registry.add(kind);
    for (const LightKind& kind : builtin_lights()) registry.add(kind);
}

}  // namespace cardioid::shaders

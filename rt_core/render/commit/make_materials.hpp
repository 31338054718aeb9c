#pragma once
#include <vector>

#include "rt_core/api/registry.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid {

/// Every material of the scene by its kind in the registry, in the scene's order; "plugin:NAME" means NAME. A scene
/// without any gets the plain "diffuse". Throws Error(bad_input) with the nearest kind or material name where one is
/// unknown, and where materials name each other in a circle.
std::vector<Material> make_materials(const Scene& scene, const Registry& registry);

/// What the ground is made of: white paper, lighter than the default material. Throws Error.
Material ground_material(const Registry& registry);

/// What the plate of a lamp is made of: it absorbs all that meets it.
Material black_material();

/// Radiance that the outer side of a material sends along wo (world), the shader's own included.
Rgb material_emission(const Material& material, const SurfacePoint& point, Vec3 wo) noexcept;

/// Whether a material shines: `emission` is set, or its shader emits straight out at the origin.
bool is_emissive(const Material& material) noexcept;

}  // namespace cardioid

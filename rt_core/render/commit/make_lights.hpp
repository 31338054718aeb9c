#pragma once
#include <memory>
#include <vector>

#include "rt_core/api/registry.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid {

/// Every light of the scene by its kind in the registry. Throws Error(bad_input) with the nearest kind where one is
/// unknown.
std::vector<std::unique_ptr<Light>> make_lights(const Scene& scene, const Registry& registry);

/// The light of a scene that has none: a soft key light from above and to the left of the default view, and the studio
/// sky. Of these only what the registry knows.
std::vector<LightSettings> studio_lights(const Registry& registry);

}  // namespace cardioid

#pragma once
#include "rt_core/api/registry.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::cli {

/// Puts into the scene what `render` would add to it: a camera where it has none, the studio's lights where nothing
/// shines.
void complete_scene(Scene& scene, const Registry& registry);

}  // namespace cardioid::cli

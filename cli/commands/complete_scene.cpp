#include "cli/commands/complete_scene.hpp"

#include "cli/commands/render_settings.hpp"
#include "csg/compile.hpp"
#include "rt_core/render/commit/make_lights.hpp"
#include "rt_core/render/lighting/direct_lighting.hpp"

namespace cardioid::cli {

void complete_scene(Scene& scene, const Registry& registry) {
    if (scene.cameras.empty()) {
        const std::unique_ptr<LightingModule> lighting = direct_lighting.make({}, 0);
        const Box3d model = bounded_box(csg::compile(scene, std::vector<bool>(scene.materials.size() + 1)));
        scene.cameras.push_back(render_settings({}, scene, model, *lighting).camera);
    }
    bool shines = !scene.lights.empty();
    for (const MaterialSettings& material : scene.materials)
        shines = shines || !is_black(material.params.colour("emission", {}));
    if (!shines) scene.lights = studio_lights(registry);
}

}  // namespace cardioid::cli

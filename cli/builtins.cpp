#include "cli/builtins.hpp"

#include "formats/openscad/openscad_format.hpp"
#include "rt_core/plugin/registry.hpp"
#include "rt_core/render/direct_lighting.hpp"
#include "shaders/builtins.hpp"

namespace cardioid::cli {
namespace {

// An explicit list: registrar objects with static constructors are dropped by the linker without a word.
void add_builtins(Registry& registry) {
    for (const ShaderKind& kind : shaders::builtin_shaders()) registry.add(kind);
    for (const LightKind& kind : shaders::builtin_lights()) registry.add(kind);
    registry.add(direct_lighting);
    registry.add(formats::csg_format);
    registry.add(formats::scad_format);
}

}  // namespace

std::unique_ptr<Registry> open_registry(const std::vector<std::string>& plugins) {
    std::unique_ptr<Registry> registry = make_registry();
    add_builtins(*registry);
    load_plugin_path(*registry);
    for (const std::string& plugin : plugins) load_plugin(plugin, *registry);
    return registry;
}

}  // namespace cardioid::cli

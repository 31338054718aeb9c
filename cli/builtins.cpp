#include "cli/builtins.hpp"

#include "formats/brlcad/brlcad_format.hpp"
#include "formats/brlcad/look/rt_lighting.hpp"
#include "formats/brlcad/look/rt_surface.hpp"
#include "formats/mesh/write/mesh_formats.hpp"
#include "formats/openscad/openscad_format.hpp"
#include "formats/povray/povray_format.hpp"
#include "photon/lighting/photon_lighting.hpp"
#include "rt_core/plugin/registry.hpp"
#include "rt_core/render/lighting/direct_lighting.hpp"
#include "rt_core/render/lighting/path_lighting.hpp"
#include "rt_core/render/lighting/whitted_lighting.hpp"
#include "shaders/builtins.hpp"

namespace cardioid::cli {
namespace {

// An explicit list: registrar objects with static constructors are dropped by the linker without a word.
void add_builtins(Registry& registry) {
    shaders::add_builtins(registry);
    registry.add(formats::brlcad::rt_surface_kind);
    registry.add(direct_lighting);
    registry.add(path_lighting);
    registry.add(whitted_lighting);
    registry.add(photon::photon_lighting);
    registry.add(formats::rt_lighting);
    registry.add(formats::csg_format);
    registry.add(formats::scad_format);
    registry.add(formats::stl_format);
    registry.add(formats::obj_format);
    registry.add(formats::ply_format);
    registry.add(formats::off_format);
    registry.add(formats::three_mf_format);
    registry.add(formats::pov_format);
    registry.add(formats::brlcad_format);
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

#include "tests/accuracy/lit_scene.hpp"

#include <fstream>
#include <sstream>

#include "csg/compile.hpp"
#include "formats/openscad/openscad_format.hpp"
#include "photon/lighting/photon_lighting.hpp"
#include "rt_core/plugin/registry.hpp"
#include "rt_core/render/lighting/path_lighting.hpp"
#include "shaders/builtins.hpp"

namespace cardioid::test {

const Registry& hooks() {
    static const std::unique_ptr<Registry> registry = [] {
        auto made = make_registry();
        shaders::add_builtins(*made);
        made->add(path_lighting);
        made->add(photon::photon_lighting);
        return made;
    }();
    return *registry;
}

Scene scene_of(const std::string& text, const std::string& name) {
    ReadOptions options;
    options.registry = &hooks();
    options.base_dir = CARDIOID_SOURCE_DIR "/samples";
    Scene scene = formats::csg_format.read(text, name, options);
    if (!scene.warnings.empty()) throw Error(ErrorCode::bad_input, scene.warnings.front());
    return scene;
}

Scene sample_scene(const std::string& file, const std::vector<std::pair<std::string, std::string>>& change) {
    std::ifstream stream(CARDIOID_SOURCE_DIR "/samples/" + file);
    if (!stream) throw Error(ErrorCode::io, file + ": cannot be read");
    std::ostringstream all;
    all << stream.rdbuf();
    std::string text = all.str();
    for (const auto& [from, to] : change) {
        std::size_t at = text.find(from);
        if (at == std::string::npos)
            throw Error(ErrorCode::bad_input, file + ": there is no \"" + from + "\" to change");
        for (; at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
    }
    return scene_of(text, file);
}

CommittedScene commit(const Scene& scene) { return {scene, hooks(), csg::compile, {.studio = false}}; }

std::unique_ptr<LightingModule> prepared_lighting(const std::string& module, const World& world, std::uint32_t seed,
                                                  const Eye* eye, const Params& options) {
    for (const LightingKind& kind : hooks().lighting())
        if (kind.name == module) {
            std::unique_ptr<LightingModule> made = kind.make(options, seed);
            Progress silent;
            made->prepare(world, eye, silent);
            return made;
        }
    throw Error(ErrorCode::usage, "there is no lighting \"" + module + "\"");
}

}  // namespace cardioid::test

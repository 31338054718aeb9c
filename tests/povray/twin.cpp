#include "tests/povray/twin.hpp"

#include <algorithm>
#include <stdexcept>

#include "cli/builtins.hpp"
#include "csg/compile.hpp"
#include "formats/openscad/openscad_format.hpp"
#include "rt_core/render/picture_eye.hpp"
#include "rt_core/render/renderer.hpp"
#include "tests/text_file.hpp"

namespace cardioid::test {
namespace {

namespace fs = std::filesystem;

const fs::path scenes = fs::path(CARDIOID_SOURCE_DIR) / "tests/povray/scenes";
const fs::path examples = "/usr/share/openscad/examples";

}  // namespace

Twin::Twin(const std::string& name) : name_(name), json_(nlohmann::json::parse(file_text(limits()))) {}

fs::path Twin::csg() const { return scenes / (name_ + ".csg"); }
fs::path Twin::limits() const { return scenes / (name_ + ".json"); }

bool Twin::can_run() const { return model().empty() || fs::exists(examples / model()); }

Scene Twin::read() const {
    ReadOptions options;
    options.registry = &registry();
    options.base_dir = scenes.string();
    Scene scene = formats::csg_format.read(file_text(csg()), csg().filename().string(), options);
    if (model().empty()) return scene;
    const fs::path path = examples / model();
    options.base_dir.clear();
    Scene model_scene = formats::scad_format.read(file_text(path), path.string(), options);
    model_scene.film = scene.film;
    model_scene.cameras = scene.cameras;
    model_scene.lights = scene.lights;
    return model_scene;
}

std::vector<std::string> twin_names() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(scenes))
        if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

const Registry& registry() {
    static const std::unique_ptr<Registry> made = cli::open_registry({});
    return *made;
}

namespace {

std::unique_ptr<LightingModule> make_lighting(const std::string& name) {
    for (const LightingKind& kind : registry().lighting())
        if (kind.name == name) return kind.make(Params("test"), 0);
    throw std::runtime_error("no lighting is called " + name);
}

}  // namespace

Picture draw(const Scene& scene, const Drawing& drawing) {
    const CommittedScene committed(scene, registry(), csg::compile, {.studio = false});
    const std::unique_ptr<LightingModule> lighting = make_lighting(drawing.lighting);
    RenderSettings settings;
    settings.width = *scene.film.width;
    settings.height = *scene.film.height;
    settings.samples = drawing.samples;
    settings.camera = scene.cameras.front();
    settings.layers = {"normal", "depth", "region"};
    Progress silence;
    const PictureEye eye(committed, settings);
    lighting->prepare(committed, &eye, silence);
    Film film = render(committed, *lighting, settings, silence).film;
    Picture out{"cardioid", film.width, film.height, 3, false, {}, {}, {}};
    const std::vector<float>& pixels = film.layers[0].pixels;
    for (std::size_t i = 0; i + 2 < pixels.size(); i += 3)
        out.pixels.emplace_back(pixels[i], pixels[i + 1], pixels[i + 2]);
    out.layers.assign(film.layers.begin() + 1, film.layers.end());
    return out;
}

}  // namespace cardioid::test

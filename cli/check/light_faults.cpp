#include <algorithm>
#include <fmt/format.h>

#include "cli/check/find_faults.hpp"
#include "cli/commands/describe.hpp"
#include "csg/compile.hpp"
#include "rt_core/render/lighting/path_lighting.hpp"
#include "rt_core/render/renderer.hpp"

namespace cardioid::cli {
namespace {

/// Of the small picture that tells whether a camera sees light.
constexpr int small_width = 48, small_height = 36, small_samples = 16;

/// Whether the lights give any; false without lights, too.
bool is_lit(const Scene& scene, const CommittedScene& committed, Findings& findings) {
    float power = 0;
    for (const auto& light : committed.lights()) power += max_component(light->power());
    if (power > 0) return true;
    if (scene.lights.empty())
        findings.notes.push_back(
            {.kind = "unlit", .text = scene.file + ": there is no light; the studio light will be used"});
    else
        findings.faults.push_back(
            {.kind = "unlit", .text = scene.file + ": the scene is unlit: its lights have no power"});
    return false;
}

/// The solids that no light enters, as one; null where there are none.
std::unique_ptr<Region> opaque_solids(const Scene& scene, const CommittedScene& committed) {
    SolidTree tree = scene.solids;
    std::erase_if(tree.roots, [&](std::uint32_t root) {
        const SolidTree part = subtree(scene.solids, root);
        const std::uint32_t material = part.leaves.empty() ? Leaf::no_material : part.leaves[0].material;
        return material < committed.materials().size() && committed.materials()[material].shader->interior();
    });
    return csg::compile_whole(tree, scene.six_digits);
}

bool is_buried(const Scene& scene, const Region* opaque, const CameraSettings& camera, Findings& findings) {
    if (!opaque) return false;
    const Sides sides = opaque->sides(camera.eye, {0, 0, 1});
    if (!sides.front || !sides.back) return false;
    findings.faults.push_back({.kind = "camera",
                               .text = fmt::format("{}: camera \"{}\" at {} is inside a solid", scene.file, camera.name,
                                                   point_text(camera.eye)),
                               .at = camera.eye});
    return true;
}

/// Whether every sample of a layer is zero.
bool is_black(const RenderResult& result, const char* layer) {
    const Layer* const found = result.film.layer(layer);
    return !found || std::all_of(found->pixels.begin(), found->pixels.end(), [](float x) { return x == 0; });
}

/// Light that comes through glass from a lamp without size reaches no path from the eye.
bool may_hide_light(const CommittedScene& committed) {
    return std::any_of(committed.materials().begin(), committed.materials().end(),
                       [](const Material& m) { return m.shader && m.shader->interior(); });
}

/// The scene with its opaque surfaces matt and grey: whether light gets to a surface does not depend on its colour.
Scene in_grey(const Scene& scene, const CommittedScene& committed) {
    Scene out = scene;
    for (std::size_t i = 0; i < out.materials.size(); ++i) {
        MaterialSettings& material = out.materials[i];
        if (committed.materials()[i].shader->interior() || material.kind == "filter") continue;
        Params params(material.params.where());
        for (const auto& [name, value] : material.params.all())
            if (name == "emission") params.set(name, value);
        material.kind = "diffuse", material.params = std::move(params);
    }
    return out;
}

/// A small path-traced picture that is black.
void find_darkness(const Scene& scene, const CommittedScene& committed, const LightingModule& paths,
                   const CameraSettings& camera, Findings& findings) {
    Progress silent;
    const RenderResult result = render(
        committed, paths,
        {.width = small_width, .height = small_height, .samples = small_samples, .camera = camera, .layers = {"depth"}},
        silent);
    if (!is_black(result, "")) return;
    const bool empty = is_black(result, "depth");
    Finding finding{.kind = "camera",
                    .text = fmt::format("{}: camera \"{}\" at {} {}", scene.file, camera.name, point_text(camera.eye),
                                        empty ? "sees nothing: it looks past the model"
                                              : "sees no light: no way leads from the lights to what is before it"),
                    .at = camera.eye};
    (may_hide_light(committed) && !empty ? findings.notes : findings.faults).push_back(std::move(finding));
}

}  // namespace

void find_light_and_camera_faults(const Scene& scene, const CommittedScene& committed, const Registry& registry,
                                  Findings& findings) {
    const bool lit = is_lit(scene, committed, findings);
    if (scene.cameras.empty()) return;
    const auto opaque = opaque_solids(scene, committed);
    const CommittedScene grey(in_grey(scene, committed), registry, csg::compile, CommitOptions{.studio = false});
    const std::unique_ptr<LightingModule> paths = path_lighting.make(Params("check"), 0);
    Progress silent;
    paths->prepare(grey, nullptr, silent);
    for (const CameraSettings& camera : scene.cameras)
        if (!is_buried(scene, opaque.get(), camera, findings) && lit)
            find_darkness(scene, grey, *paths, camera, findings);
}

}  // namespace cardioid::cli

#include <map>
#include <stdexcept>

#include "tests/povray/twin.hpp"

namespace cardioid::test {
namespace {

void scale(Params& params, const std::string& name, double by) {
    if (!params.has(name)) return;
    for (const auto& [key, value] : params.all())
        if (key == name) {
            ParamValue changed = value;
            for (double& x : changed.numbers) x *= by;
            params.set(name, changed);
            return;
        }
}

/// All lights 2 % brighter.
void brighter(Scene& scene) {
    for (LightSettings& light : scene.lights)
        for (const char* name : {"intensity", "power", "radiance", "irradiance"}) scale(light.params, name, 1.02);
}

/// Everything that ends 1 % larger, each part about its own middle.
void larger(Scene& scene) {
    for (Leaf& leaf : scene.solids.leaves) {
        if (leaf.kind == LeafKind::half_space) continue;
        const bool from_corner = leaf.kind == LeafKind::box;
        const double low = from_corner ? -0.005 : 0;
        leaf.to_world = leaf.to_world * Affine{{Vec3d{1.01, 0, 0}, {0, 1.01, 0}, {0, 0, 1.01}}, {low, low, low}};
    }
}

/// x and y of all solids taken one for the other.
void swapped(Scene& scene) {
    const Affine swap{{Vec3d{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}, {}};
    for (Leaf& leaf : scene.solids.leaves) leaf.to_world = swap * leaf.to_world;
}

template <class Change>
void each_material(Scene& scene, const std::string& kind, Change&& change) {
    for (MaterialSettings& material : scene.materials)
        if (material.kind == kind) change(material.params);
}

void denser(Scene& scene) {
    each_material(scene, "dielectric", [](Params& p) { p.set("ior", p.number("ior", 1.5) + 0.02); });
}

/// Glass that has forgotten to absorb.
void clear(Scene& scene) {
    each_material(scene, "dielectric", [](Params& p) {
        if (p.has("absorption")) p.set("absorption", 0.0);
        if (p.has("transmittance")) p.set("transmittance", 1.0);
    });
}

const std::map<std::string, void (*)(Scene&)>& mistakes() {
    static const std::map<std::string, void (*)(Scene&)> all{
        {"light", brighter},
        {"size", larger},
        {"axis", swapped},
        {"ior", denser},
        {"fade", clear},
        {"mirror", [](Scene& s) { each_material(s, "mirror", [](Params& p) { scale(p, "reflectance", 0.98); }); }},
        {"lens", [](Scene& s) { s.cameras.front().lens_radius *= 2; }},
        {"phong",
         [](Scene& s) {
             each_material(s, "pov_finish", [](Params& p) { p.set("phong_size", p.number("phong_size", 40) * 1.1); });
         }},
        {"checker", [](Scene& s) { each_material(s, "checker", [](Params& p) { scale(p, "size", 1.01); }); }}};
    return all;
}

}  // namespace

Scene with_mistake(Scene scene, const std::string& mistake) {
    const auto found = mistakes().find(mistake);
    if (found == mistakes().end()) throw std::runtime_error("no mistake is called " + mistake);
    found->second(scene);
    return scene;
}

Scene outline_of(Scene scene) {
    if (scene.materials.empty()) scene.materials.push_back({"default", "emitter", {}});
    for (MaterialSettings& material : scene.materials) {
        material.kind = "emitter";
        material.params = Params("outline");
        // The floor is left black, so that the outlines of what stands on it are seen before it.
        if (material.name != "floor" && material.name != "board") material.params.set("emission", 1.0);
    }
    scene.lights.clear();
    return scene;
}

}  // namespace cardioid::test

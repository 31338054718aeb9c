#include "formats/brlcad/scene/assemble.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

#include "formats/brlcad/scene/charts.hpp"
#include "formats/brlcad/scene/facts.hpp"
#include "formats/brlcad/scene/looks.hpp"
#include "formats/brlcad/scene/regions.hpp"
#include "formats/brlcad/scene/rt_look.hpp"
#include "formats/brlcad/view/view_script.hpp"
#include "formats/openscad/prune.hpp"
#include "rt_core/scene/nearest_name.hpp"

namespace cardioid::formats::brlcad {

namespace {

enum class Look { physical, rt };

Look chosen_look(const ReadOptions& options) {
    Look look = Look::physical;
    for (const auto& [name, value] : options.settings) {
        static constexpr std::string_view names[] = {"look"}, looks[] = {"physical", "rt"};
        if (name != "look")
            throw Error(ErrorCode::usage, fmt::format("--set brlcad.{}={}: found option \"{}\", wanted look{}", name,
                                                      value, name, did_you_mean(name, names)));
        if (value != "physical" && value != "rt")
            throw Error(ErrorCode::usage, fmt::format("--set brlcad.look={}: wanted physical or rt{}", value,
                                                      did_you_mean(value, looks)));
        look = value == "rt" ? Look::rt : Look::physical;
    }
    return look;
}

/// Throws Error(usage) with the nearest name where an object is not there.
void check_objects(const Database& database, const std::vector<std::string>& objects, const std::string& file) {
    for (const std::string& name : objects) {
        if (database.find(name)) continue;
        std::vector<std::string_view> known;
        for (const Object& object : database.objects) known.push_back(object.name);
        throw Error(ErrorCode::usage,
                    fmt::format("{}: there is no object \"{}\" in it{}", file, name, did_you_mean(name, known)));
    }
}

/// Materials by look, each once; those that depend on the size of their region are one for each.
class Materials final : public Surfaces {
public:
    Materials(Scene& scene, Look look) : scene_(scene), look_(look) {
        scene_.materials.push_back(make({}));
        scene_.materials.back().name = "default";
    }

    std::uint32_t of_region(const RegionLook& given) override {
        RegionLook look = given;
        look.region_id = 0;  // its colour is in the look already
        const std::string key = key_of(look);
        if (const auto found = known_.find(key); found != known_.end()) return found->second;
        MaterialSettings material = make(look);
        const bool own = material.kind == "dielectric" || material.kind == "checker" || material.kind == "emitter" ||
                         parse_shader(look.shader).name == "light";
        const auto index = static_cast<std::uint32_t>(scene_.materials.size());
        material.name = own ? fmt::format("{} #{}", key, index) : key;
        scene_.materials.push_back(std::move(material));
        if (!own) known_.emplace(key, index);
        return index;
    }

    /// A texture follows the coordinates of the solid it is on.
    std::uint32_t of_solid(std::uint32_t material, const Solid& solid, const Affine& place) override {
        if (!scene_.materials[material].params.has("texture") || look_ != Look::rt) return material;
        const auto index = static_cast<std::uint32_t>(scene_.materials.size());
        MaterialSettings own = scene_.materials[material];
        own.name += fmt::format(" #{}", index);
        own.params.set("chart", ParamValue{.numbers = chart_of(solid, place), .list = true});
        scene_.materials.push_back(std::move(own));
        return index;
    }

private:
    static std::string key_of(const RegionLook& look) {
        const Rgb c = display_colour(look);
        return fmt::format("{} {:.0f}/{:.0f}/{:.0f}", parse_shader(look.shader).plain(), c.r * 255, c.g * 255,
                           c.b * 255);
    }
    MaterialSettings make(const RegionLook& look) {
        if (look_ == Look::rt) return rt_material(look);
        std::vector<std::string> notes;
        MaterialSettings out = physical_material(look, notes);
        for (const std::string& note : notes)
            if (noted_.insert(note).second) scene_.warnings.push_back(scene_.file + ": " + note);
        return out;
    }

    Scene& scene_;
    Look look_;
    std::map<std::string, std::uint32_t> known_;
    std::set<std::string> noted_;
};

/// What is drawn where nothing is named: solids in no combination are what building the others has left over, unless
/// there is nothing else.
std::vector<std::string> drawn_by_itself(const Database& database, Scene& scene) {
    std::set<std::string> combinations;
    for (const Object& object : database.objects)
        if (object.combination && !object.combination->steps.empty()) combinations.insert(object.name);
    std::vector<std::string> drawn, left;
    for (const std::string& name : scene.tops) (combinations.contains(name) ? drawn : left).push_back(name);
    if (drawn.empty()) return left;
    if (!left.empty())
        scene.warnings.push_back(fmt::format("{}: in no combination and left out; name them to draw them: {}",
                                             scene.file, fmt::join(left, ", ")));
    return drawn;
}

}  // namespace

Scene assemble(Database database, const std::string& file, const ReadOptions& options) {
    const Look look = chosen_look(options);
    Scene scene;
    scene.file = file;
    scene.warnings = std::move(database.warnings);
    scene.tops = top_objects(database);
    scene.facts = facts_of(database, scene.tops);
    check_objects(database, options.objects, file);
    Materials materials(scene, look);
    std::vector<std::string> warnings;
    const std::vector<std::string> objects =
        options.objects.empty() ? drawn_by_itself(database, scene) : options.objects;
    std::vector<Region> regions = collect_regions(database, objects, materials, scene.solids, warnings);
    scene.warnings.insert(scene.warnings.end(), warnings.begin(), warnings.end());
    if (look == Look::rt)
        finish_rt(scene, regions);
    else
        finish_physical(scene, regions);
    if (regions.empty())
        throw Error(ErrorCode::bad_input, fmt::format("{}: found no solid in {}{}", file,
                                                      options.objects.empty() ? "it" : "\"" + options.objects[0] + "\"",
                                                      warnings.empty() ? "" : "; " + warnings[0]));
    for (Region& region : regions) {
        scene.solids.roots.push_back(region.node);
        scene.names.push_back(std::move(region.path));
    }
    openscad::prune(scene.solids);
    if (look == Look::rt) scene.fitted.parallel = true;
    if (!options.view_text.empty()) apply_views(read_views(options.view_text, options.view_file), scene);
    if (look == Look::rt) {
        scene.lighting = "rt";
        if (!scene.film.width) scene.film.width = scene.film.height = 512;
        scene.film.samples = 1;
        for (CameraSettings& camera : scene.cameras) camera.pixel_shift = {-0.5, 0.5};
        scene.fitted.pixel_shift = {-0.5, 0.5};
    }
    return scene;
}

}  // namespace cardioid::formats::brlcad

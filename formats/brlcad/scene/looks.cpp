#include "formats/brlcad/scene/looks.hpp"

#include <algorithm>
#include <cmath>

#include "csg/exact/walk.hpp"
#include "csg/leaves/leaf.hpp"

namespace cardioid::formats::brlcad {

namespace {

/// What no real surface exceeds.
constexpr float whitest = 0.9F;
/// Fields of a checker along the longest side of its region.
constexpr double fields = 10;

float linear(float encoded) {
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

/// Roughness of a coat whose highlight is about as wide as Phong's of that exponent (Walter et al. 2007: alpha^2 = 2 /
/// (n + 2), alpha the square of the roughness).
double roughness(double shine) { return std::pow(2 / (std::max(shine, 0.0) + 2), 0.25); }

Rgb mixed(Rgb a, Rgb b, float share) { return a * (1 - share) + b * share; }

Rgb colour_or(const ShaderText& shader, const char* key, Rgb fallback) {
    const std::vector<double> v = shader.triple(key);
    if (v.empty()) return fallback;
    const auto channel = [&](std::size_t i) {
        return linear(static_cast<float>(std::clamp(v[i], 0.0, 255.0) / 255)) * whitest;
    };
    return {channel(0), channel(1), channel(2)};
}

/// Of a sky of clouds: half of it white, half the blue that the shader has between them.
constexpr Rgb cloudy{0.4F, 0.4F, 0.7F};

bool hollow_ball(const SolidTree& tree, std::uint32_t node) {
    bool all = tree.nodes[node].op == SolidOp::subtract;
    csg::for_each_leaf(tree, node, [&](const Leaf& leaf) { all = all && leaf.kind == LeafKind::sphere; });
    return all;
}

/// Whether a region stands for the sky: of clouds or an opaque hollow ball, and around all others. Light would not get
/// in, nor a look from outside.
bool is_dome(const Scene& scene, const std::vector<Region>& regions, const Region& region) {
    const std::string shader = parse_shader(region.look.shader).name;
    const bool opaque_shell = shader != "glass" && shader != "light" && hollow_ball(scene.solids, region.node);
    if (regions.size() < 2 || (shader != "cloud" && !opaque_shell)) return false;
    const Box3d dome = box_of(scene.solids, region.node);
    return std::all_of(regions.begin(), regions.end(), [&](const Region& other) {
        const Box3d box = box_of(scene.solids, other.node);
        return box.empty() || (dome.contains(box.lo) && dome.contains(box.hi));
    });
}

Rgb sky_radiance(const RegionLook& look) {
    const ShaderText shader = parse_shader(look.shader);
    const bool clouds =
        shader.name == "cloud" || std::find(shader.others.begin(), shader.others.end(), "cloud") != shader.others.end();
    return clouds ? cloudy : colour_or(shader, "a", reflectance(look));
}

void add_sky(Scene& scene, const Region& region) {
    LightSettings sky{.kind = "sky", .params = Params(region.path), .to_world = {}};
    sky.params.set("radiance", sky_radiance(region.look));
    scene.lights.push_back(std::move(sky));
}

/// Lamps of one brightness ratio as in the file; the brightest gives a white surface in the middle of the model the
/// radiance 1 where it faces it.
void set_lamps(Scene& scene, const std::vector<Region>& regions) {
    Box3d model;
    double brightest = 0;
    for (const Region& region : regions) {
        const Box3d box = box_of(scene.solids, region.node);
        if (!box.empty() && !is_light(region.look)) model.include(box);
        if (is_light(region.look)) brightest = std::max(brightest, intensity(region.look));
    }
    if (!(brightest > 0) || model.empty()) return;
    for (const Region& region : regions) {
        if (!is_light(region.look)) continue;
        const ShaderText shader = parse_shader(region.look.shader);
        const Box3d box = box_of(scene.solids, region.node);
        const double size = box.diagonal() / 2, away = length(box.centre() - model.centre());
        const double distance = std::max(away, model.diagonal() / 4);
        const double share = shader.number({"fract", "f"}, intensity(region.look) / brightest);
        // A ball of the lamp's size has pi r^2 across, and pi is the white surface's share.
        const double radiance = size > 0 ? share * 3 * distance * distance / (size * size) : 0;
        MaterialSettings& material = scene.materials[region.material];
        material.params.set("emission", reflectance(region.look) * static_cast<float>(radiance / whitest));
    }
}

}  // namespace

Box3d box_of(const SolidTree& tree, std::uint32_t node) {
    Box3d out;
    csg::for_each_leaf(tree, node, [&](const Leaf& leaf) {
        const Box3d box = csg::leaf_bounds(tree, leaf);
        if (box.bounded()) out.include(box);
    });
    return out;
}

bool is_light(const RegionLook& look) { return parse_shader(look.shader).name == "light"; }

double intensity(const RegionLook& look) {
    return std::max(parse_shader(look.shader).number({"bright", "b", "inten"}, 1), 0.0);
}

Rgb display_colour(const RegionLook& look) {
    if (!look.colour) return Rgb(1);
    const auto channel = [&](std::size_t i) { return static_cast<float>((*look.colour)[i]) / 255; };
    return {channel(0), channel(1), channel(2)};
}

Rgb reflectance(const RegionLook& look) {
    const Rgb c = display_colour(look);
    return Rgb(linear(c.r), linear(c.g), linear(c.b)) * whitest;
}

MaterialSettings physical_material(const RegionLook& look, std::vector<std::string>& notes) {
    const ShaderText shader = parse_shader(look.shader);
    MaterialSettings out;
    out.params = Params("shader \"" + look.shader + "\"");
    const Rgb colour = reflectance(look);
    const double re = std::clamp(shader.number({"re"}, shader.name == "mirror" ? 0.75 : 0), 0.0, 1.0);
    for (const std::string& other : shader.others)
        if (other != "checker") notes.push_back("shader \"" + other + "\" of a stack is left out");
    const bool checker = shader.name == "checker" ||
                         std::find(shader.others.begin(), shader.others.end(), "checker") != shader.others.end();
    if (checker) {
        out.kind = "checker";
        out.params.set("a", colour_or(shader, "a", colour));
        out.params.set("b", colour_or(shader, "b", Rgb(0.01F)));
    } else if (shader.name == "light") {
        out.kind = "emitter";
    } else if (shader.name == "glass") {
        out.kind = "dielectric";
        out.params.set("ior", std::clamp(shader.number({"ri"}, 1.65), 1.0, 4.0));
    } else if (shader.name == "mirror" || re >= 0.5) {
        out.kind = "mirror";
        out.params.set("reflectance", mixed(colour, Rgb(1), static_cast<float>(re)));
    } else {
        static const std::vector<std::string> plain{"", "plastic", "phong", "cook", "stack", "envmap"};
        if (std::find(plain.begin(), plain.end(), shader.name) == plain.end())
            notes.push_back("shader \"" + shader.name + "\" is drawn as plastic of its region's colour");
        out.kind = "plastic";
        out.params.set("reflectance", colour);
        out.params.set("roughness", re > 0 ? 0.0 : roughness(shader.number({"sh", "shine"}, 10)));
    }
    return out;
}

void finish_physical(Scene& scene, std::vector<Region>& regions) {
    const auto dome = std::find_if(regions.begin(), regions.end(),
                                   [&](const Region& region) { return is_dome(scene, regions, region); });
    if (dome != regions.end()) {
        add_sky(scene, *dome);
        regions.erase(dome);
    }
    std::erase_if(regions, [&](const Region& region) {
        if (parse_shader(region.look.shader).name != "envmap") return false;
        add_sky(scene, region);
        return true;
    });
    for (const Region& region : regions) {
        MaterialSettings& material = scene.materials[region.material];
        const Box3d box = box_of(scene.solids, region.node);
        if (box.empty()) continue;
        const Vec3d size = box.size();
        if (material.kind == "checker") material.params.set("size", max_component(size) / fields);
        if (material.kind == "dielectric" && region.look.colour && region.look.colour != Colour8{255, 255, 255}) {
            material.params.set("transmittance", mixed(reflectance(region.look) * (1 / whitest), Rgb(1), 0.01F));
            material.params.set("distance", std::min({size.x, size.y, size.z}));
        }
    }
    set_lamps(scene, regions);
}

}  // namespace cardioid::formats::brlcad

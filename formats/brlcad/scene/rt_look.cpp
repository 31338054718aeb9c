#include "formats/brlcad/scene/rt_look.hpp"

#include <algorithm>

#include "formats/brlcad/scene/looks.hpp"

namespace cardioid::formats::brlcad {

namespace {

/// rt's default of `-A`.
constexpr double ambient = 0.4;

/// Defaults of sh_plastic.c: shine, specular, diffuse, transmit, reflect, index.
struct Defaults {
    const char* name;
    double sh, sp, di, tr, re, ri;
};
constexpr Defaults defaults[] = {
    {"plastic", 10, 0.7, 0.3, 0, 0, 1}, {"mirror", 4, 0.6, 0.4, 0, 0.75, 1.65}, {"glass", 4, 0.7, 0.3, 0.8, 0.1, 1.65}};

/// The texture of a shader, and whether it is shown without light: where it is not within a stack below a surface.
void set_texture(const ShaderText& shader, Params& params) {
    const auto named = [&](const char* name) {
        return shader.name == name ||
               std::find(shader.others.begin(), shader.others.end(), name) != shader.others.end();
    };
    const auto colour = [&](const char* key, double fallback) {
        std::vector<double> v = shader.triple(key);
        if (v.empty()) v.assign(3, fallback);
        const auto channel = [&](std::size_t i) { return static_cast<float>(std::clamp(v[i], 0.0, 255.0) / 255); };
        params.set(key, Rgb(channel(0), channel(1), channel(2)));
    };
    const auto number = [&](const char* name, const char* key, double fallback, double least, double most) {
        params.set(name, std::clamp(shader.number({key}, fallback), least, most));
    };
    const char* kind = named("checker")   ? "checker"
                       : named("cloud")   ? "cloud"
                       : named("testmap") ? "testmap"
                       : named("texture") ? "image"
                                          : nullptr;
    if (!kind) return;
    params.set("texture", std::string(kind));
    colour("a", 255);
    colour("b", 0);
    number("scale", "s", 2, 0, 1e6);
    number("threshold", "thresh", 0.35, -1e6, 1e6);
    number("range", "range", 0.3, 1e-6, 1e6);
    number("width", "w", 512, 1, 16384);
    number("height", "n", shader.number({"l"}, shader.number({"w"}, 512)), 1, 16384);
    const auto file = shader.values.find("file");
    if (file != shader.values.end()) params.set("file", file->second);
    if (shader.name == "checker" || shader.name == "cloud" || shader.name == "testmap" || shader.name == "texture")
        params.set("flat", 1.0);
}

}  // namespace

MaterialSettings rt_material(const RegionLook& look) {
    const ShaderText shader = parse_shader(look.shader);
    MaterialSettings out{.kind = "rt_surface", .params = Params("shader \"" + look.shader + "\"")};
    const Defaults* row = &defaults[0];
    for (const Defaults& d : defaults)
        if (shader.name == d.name) row = &d;
    const auto set = [&](const char* name, std::initializer_list<const char*> keys, double fallback, double most) {
        out.params.set(name, std::clamp(shader.number(keys, fallback), 0.0, most));
    };
    out.params.set("colour", display_colour(look));
    set("shine", {"sh", "shine"}, row->sh, 1e6);
    set("specular", {"sp", "specular"}, row->sp, 100);
    set("diffuse", {"di", "diffuse"}, row->di, 100);
    set("transmit", {"tr", "transmit"}, row->tr, 1);
    set("reflect", {"re", "reflect"}, row->re, 1);
    set("index", {"ri"}, row->ri, 10);
    set_texture(shader, out.params);
    return out;
}

void finish_rt(Scene& scene, std::vector<Region>& regions) {
    std::erase_if(regions, [&](const Region& region) {
        const ShaderText shader = parse_shader(region.look.shader);
        if (shader.name == "envmap") scene.materials[region.material].params.set("around", 1.0);
        return shader.name == "envmap" || shader.name == "air";
    });
    double brightest = 0;
    for (const Region& region : regions)
        if (is_light(region.look)) brightest = std::max(brightest, intensity(region.look));
    std::vector<Region> kept;
    for (Region& region : regions) {
        if (is_light(region.look) && brightest > 0) {
            const ShaderText shader = parse_shader(region.look.shader);
            const Vec3d at = box_of(scene.solids, region.node).centre();
            Params& params = scene.materials[region.material].params;
            const double share =
                shader.number({"fract", "f"}, intensity(region.look) / (brightest * (1 + 0.5 * ambient)));
            params.set("light", std::clamp(share, 0.0, 1e6));
            params.set("angle", std::clamp(shader.number({"angle", "a"}, 180), 0.0, 180.0));
            params.set("shadows", shader.number({"shadows", "s"}, 1) > 0 ? 1.0 : 0.0);
            params.set("place", ParamValue{.numbers = {at.x, at.y, at.z}, .list = true});
        }
        kept.push_back(std::move(region));
    }
    regions = std::move(kept);
}

}  // namespace cardioid::formats::brlcad

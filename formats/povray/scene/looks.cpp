#include "formats/povray/scene/looks.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string_view>

namespace cardioid::formats::povray {

namespace {

/// A material that is being said in POV-Ray's terms.
struct Translation {
    const MaterialSettings& material;
    double scale;
    Notes& notes;

    [[nodiscard]] const Params& params() const { return material.params; }
    void note(const std::string& text) const {
        notes.add(params().where(), fmt::format("material \"{}\" ({}): {}", material.name, material.kind, text));
    }
};

float mean(Rgb c) { return (c.r + c.g + c.b) / 3; }
bool is_grey(Rgb c) { return c.r == c.g && c.g == c.b; }

Look diffuse(const Translation& t) {
    return {.pigment = t.params().colour("reflectance", Rgb(0.5F)), .diffuse = true, .finish = "diffuse 1"};
}

Look mirror(const Translation& t) {
    const Rgb r = t.params().colour("reflectance", Rgb(1));
    return {.finish = fmt::format("reflection {{ {} }}", sdl(r)), .specular = true};
}

/// Beer and Lambert's law by a medium: fade_power would be the same but for light that is reflected inside, which
/// POV-Ray then does not absorb.
std::string absorbing(Rgb sigma) {
    return is_black(sigma) ? "" : fmt::format(" media {{ absorption {} }}", sdl(sigma));
}

Rgb absorption(const Params& p, double scale) {
    Rgb sigma = p.colour("absorption", {});
    if (p.has("transmittance")) {
        const Rgb left = p.colour("transmittance", Rgb(1));
        const double distance = p.number("distance", 1);
        const auto channel = [&](float x) { return static_cast<float>(-std::log(double{x}) / distance) + 0.0F; };
        sigma = {channel(left.r), channel(left.g), channel(left.b)};
    }
    return sigma * static_cast<float>(1 / scale);
}

Look dielectric(const Translation& t) {
    const Params& p = t.params();
    if (p.number("roughness", 0) > 0) t.note("POV-Ray has no rough glass; it is written smooth");
    if (p.number("priority", 0) != 0) t.note("POV-Ray has no priorities where transparent solids overlap");
    return {.transmit = 1,
            .finish = "reflection { 0, 1 fresnel on } conserve_energy",
            .interior = fmt::format("ior {}{}", sdl(p.number("ior", 1.5)), absorbing(absorption(p, t.scale))),
            .specular = true,
            .straight_shadows = p.boolean("straight_shadows", false)};
}

Look filter(const Translation& t) {
    const Rgb passing = t.params().colour("transmittance", Rgb(0.5F));
    if (!is_grey(passing)) t.note("transmittance is written grey");
    return {.pigment = t.params().colour("reflectance", Rgb(0.5F)),
            .transmit = mean(passing),
            .diffuse = true,
            .finish = "diffuse 1",
            .interior = "ior 1",
            .straight_shadows = true};
}

/// The highlight of POV-Ray has no cosine towards the light, as equation 7 of ARL-TR-3608 has none.
Look phong(const Translation& t) {
    const Params& p = t.params();
    const Rgb kd = p.colour("diffuse", Rgb(0.5F)), ks = p.colour("specular", Rgb(0.2F));
    const double n = p.number("exponent", 20);
    const bool normalized = p.boolean("normalized", true);
    if (normalized) t.note("POV-Ray's highlight has no cosine towards the light; kind = \"pov_finish\" matches it");
    if (p.has("attenuation") || p.has("attenuation_p")) t.note("attenuation is left out");
    if (!is_grey(ks)) t.note("the highlight is written grey");
    const double strength = double{mean(ks)} * (normalized ? (n + 2) / 2 : std::numbers::pi);
    return {.pigment = normalized ? kd : kd * std::numbers::pi_v<float>,
            .diffuse = true,
            .finish = fmt::format("diffuse 1 phong {} phong_size {}", sdl(strength), sdl(n))};
}

Look pov_finish(const Translation& t) {
    const Params& p = t.params();
    return {
        .pigment = p.colour("pigment", Rgb(0.5F)),
        .diffuse = true,
        .finish = fmt::format("diffuse {} brilliance {} phong {} phong_size {} specular {} roughness {} metallic {}",
                              sdl(p.number("diffuse", 1)), sdl(p.number("brilliance", 1)), sdl(p.number("phong", 0)),
                              sdl(p.number("phong_size", 40)), sdl(p.number("specular", 0)),
                              sdl(p.number("roughness", 0.05)), sdl(p.number("metallic", 0)))};
}

/// Share of unpolarised light that a smooth surface of this index reflects, of what comes evenly from all sides.
double mean_fresnel(double ior) {
    constexpr int steps = 256;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double c = (i + 0.5) / steps, t = std::sqrt(1 - (1 - c * c) / (ior * ior));
        const double s = (c - ior * t) / (c + ior * t), p = (t - ior * c) / (t + ior * c);
        sum += (s * s + p * p) * c / steps;
    }
    return sum;
}

/// What the body under a coat reflects of light from all sides: it enters, is reflected inside any number of times, and
/// leaves. POV-Ray's reflection takes nothing off what is matt, so all of it has to be in the pigment.
Rgb coated(Rgb reflectance, double ior) {
    const double entering = 1 - mean_fresnel(ior), leaving = entering / (ior * ior);
    const auto channel = [&](float r) {
        return static_cast<float>(entering * leaving * double{r} / (1 - double{r} * (1 - leaving)));
    };
    return {channel(reflectance.r), channel(reflectance.g), channel(reflectance.b)};
}

Look plastic(const Translation& t) {
    t.note(
        "a coat over a matt body is written as a mirror of Fresnel's strength over it, the body as bright as from "
        "all sides");
    if (t.params().number("roughness", 0) > 0) t.note("POV-Ray has no rough coat; it is written smooth");
    const double ior = t.params().number("ior", 1.5);
    return {.pigment = coated(t.params().colour("reflectance", Rgb(0.5F)), ior),
            .diffuse = true,
            .finish = "diffuse 1 reflection { 0, 1 fresnel on }",
            .interior = fmt::format("ior {}", sdl(ior)),
            .specular = true};
}

/// Reflectance of smooth metals seen from the front, linear Rec.709, from the indices of refraction of the tables that
/// kind `conductor` has.
struct Metal {
    std::string_view name;
    Rgb reflectance;
};
constexpr Metal metals[] = {{"aluminium", {0.912F, 0.914F, 0.920F}}, {"chromium", {0.550F, 0.556F, 0.554F}},
                            {"copper", {0.955F, 0.638F, 0.538F}},    {"gold", {1.0F, 0.766F, 0.336F}},
                            {"iron", {0.562F, 0.565F, 0.578F}},      {"nickel", {0.660F, 0.609F, 0.526F}},
                            {"silver", {0.972F, 0.960F, 0.915F}},    {"titanium", {0.542F, 0.497F, 0.449F}}};

Rgb front_reflectance(const Params& p) {
    if (p.has("eta") || p.has("k")) {
        const Rgb eta = p.colour("eta", Rgb(1)), k = p.colour("k", {});
        const auto channel = [](float n, float x) { return ((n - 1) * (n - 1) + x * x) / ((n + 1) * (n + 1) + x * x); };
        return {channel(eta.r, k.r), channel(eta.g, k.g), channel(eta.b, k.b)};
    }
    const std::string name = p.text("metal", "aluminium");
    for (const Metal& metal : metals)
        if (metal.name == name) return metal.reflectance;
    return metals[0].reflectance;
}

/// A metal seen from the front, with Schlick's rise towards grazing angles (1994).
Look conductor(const Translation& t) {
    t.note("the reflectance of a metal is written by Schlick's formula");
    if (t.params().number("roughness", 0) > 0) t.note("POV-Ray has no rough metal; it is written smooth");
    return {.finish = fmt::format("reflection {{ {}, rgb 1 falloff 5 }}", sdl(front_reflectance(t.params()))),
            .specular = true};
}

Look emitter(const Translation&) { return {}; }

struct Kind {
    std::string_view name;
    Look (*look)(const Translation&);
};
constexpr Kind kinds[] = {{"diffuse", diffuse},       {"phong", phong},     {"plastic", plastic},
                          {"mirror", mirror},         {"filter", filter},   {"conductor", conductor},
                          {"dielectric", dielectric}, {"emitter", emitter}, {"pov_finish", pov_finish}};

}  // namespace

Look look_of(const MaterialSettings& material, double scale, Notes& notes) {
    const Translation translation{material, scale, notes};
    for (const Kind& kind : kinds)
        if (kind.name == material.kind) return kind.look(translation);
    translation.note("POV-Ray has nothing like it; it is written matt and grey");
    return {.pigment = Rgb(0.5F), .diffuse = true, .finish = "diffuse 1"};
}

}  // namespace cardioid::formats::povray

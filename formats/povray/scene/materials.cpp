#include "formats/povray/scene/materials.hpp"

#include <fmt/format.h>

#include "formats/povray/scene/looks.hpp"

namespace cardioid::formats::povray {

namespace {

/// A pigment this dark reflects nothing to speak of, and still tells how much is emitted.
constexpr float nearly_black = 1e-6F;

/// Emission is a share of the pigment; where the pigment reflects it is left alone and the share made to fit.
std::string emission(Rgb Le, Look& look) {
    if (is_black(Le)) return "";
    if (!look.diffuse) {
        look.pigment = Le;
        return " emission 1";
    }
    const auto share = [](float e, float& pigment) {
        if (e > 0) pigment = std::max(pigment, nearly_black);
        return e > 0 ? e / pigment : 0;
    };
    const Rgb shares{share(Le.r, look.pigment.r), share(Le.g, look.pigment.g), share(Le.b, look.pigment.b)};
    return fmt::format(" emission {}", sdl(shares));
}

class MaterialWriter {
public:
    MaterialWriter(const Scene& scene, double scale, Notes& notes) : scene_(scene), scale_(scale), notes_(notes) {
        materials_.all.resize(scene.materials.size());
        busy_.resize(scene.materials.size());
    }

    Materials run() {
        if (scene_.materials.empty()) plain();
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) write(i);
        return std::move(materials_);
    }

private:
    /// What solids without a material are made of: kind diffuse as it is by itself.
    void plain() {
        materials_.declarations = "#declare M_default = texture { pigment { rgb 0.5 } finish { diffuse 1 } }\n";
        materials_.all.push_back({.texture = "M_default"});
    }

    /// Writes the materials that this one is made of before it.
    void write(std::size_t index) {
        if (busy_[index]) return;
        busy_[index] = true;
        const MaterialSettings& settings = scene_.materials[index];
        if (settings.kind == "checker")
            checker(settings, materials_.all[index]);
        else
            uniform(settings, materials_.all[index]);
    }

    std::string declare(const std::string& prefix, const MaterialSettings& settings, const std::string& what) {
        const std::string id = names_.make(prefix, settings.name.empty() ? "default" : settings.name);
        materials_.declarations += fmt::format("#declare {} = {}\n", id, what);
        return id;
    }

    void uniform(const MaterialSettings& settings, Material& out) {
        Look look = look_of(settings, scale_, notes_);
        const Rgb Le = settings.params.colour("emission", {});
        const std::string shine = emission(Le, look);
        if (!is_black(Le) && look.transmit > 0)
            notes_.add(settings.params.where(),
                       fmt::format("material \"{}\": POV-Ray dims the emission of what light passes", settings.name));
        const std::string transmit = look.transmit > 0 ? fmt::format(" transmit {:.9g}", look.transmit) : "";
        const std::string pigment = look.transmit == 1 ? "rgbt 1" : sdl(look.pigment) + transmit;
        out.texture =
            declare("M_", settings,
                    fmt::format("texture {{ pigment {{ {} }} finish {{ {}{} }} }}", pigment, look.finish, shine));
        if (!look.interior.empty())
            out.interior = declare("I_", settings, fmt::format("interior {{ {} }}", look.interior));
        out.transparent = look.transmit > 0;
        out.fills = out.transparent && look.specular;
        out.opaque_shadow = out.transparent && !look.straight_shadows;
        out.photon_target = look.specular;
    }

    /// A field of a checker as a texture: a colour, or another material.
    std::string field(const MaterialSettings& settings, const char* name, float fallback) {
        if (!settings.params.is_text(name))
            return fmt::format("texture {{ pigment {{ {} }} finish {{ diffuse 1 }} }}",
                               sdl(settings.params.colour(name, Rgb(fallback))));
        const std::string wanted = settings.params.text(name);
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
            if (scene_.materials[i].name != wanted) continue;
            write(i);
            if (!materials_.all[i].texture.empty()) return fmt::format("texture {{ {} }}", materials_.all[i].texture);
        }
        settings.params.wrong(name, "the name of a material; there is no \"" + wanted + "\"");
    }

    void checker(const MaterialSettings& settings, Material& out) {
        const std::string a = field(settings, "a", 0.8F), b = field(settings, "b", 0.2F);
        out.field = settings.params.number("size", 1) * scale_;
        out.texture =
            declare("M_", settings, fmt::format("texture {{ checker {} {} scale {} }}", a, b, sdl(out.field)));
    }

    const Scene& scene_;
    double scale_;
    Notes& notes_;
    Identifiers names_;
    Materials materials_;
    std::vector<bool> busy_;
};

}  // namespace

Materials write_materials(const Scene& scene, double scale, Notes& notes) {
    return MaterialWriter(scene, scale, notes).run();
}

}  // namespace cardioid::formats::povray

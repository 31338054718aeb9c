#include "rt_core/render/commit/make_materials.hpp"

#include <string_view>

#include "rt_core/scene/nearest_name.hpp"

namespace cardioid {

namespace {

/// White paper, so that the grey default material stands out from it.
constexpr double ground_reflectance = 0.85;

class BlackBsdf final : public Bsdf {
public:
    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::none; }
    [[nodiscard]] Rgb f(Vec3, Vec3) const noexcept override { return {}; }
    [[nodiscard]] float pdf(Vec3, Vec3, Lobe) const noexcept override { return 0; }
    [[nodiscard]] BsdfSample sample(Vec3, float, Vec2, Lobe) const noexcept override { return {}; }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return {}; }
};

class BlackShader final : public Shader {
public:
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept override {
        return memory.make<BlackBsdf>();
    }
};

/// Makes each material once, those that others name first.
class Maker {
public:
    Maker(const Scene& scene, const Registry& registry) : scene_(scene), registry_(registry) {
        made_.resize(scene.materials.size());
        busy_.resize(scene.materials.size());
    }

    std::shared_ptr<const Shader> make(std::size_t i) {
        if (made_[i]) return made_[i];
        const MaterialSettings& settings = scene_.materials[i];
        if (busy_[i])
            throw Error(ErrorCode::bad_input,
                        settings.params.where() + ": material \"" + settings.name + "\" is made of itself");
        busy_[i] = true;
        const ShaderInputs inputs{settings.params, [&](std::string_view name) { return named(name, settings); }};
        return made_[i] = kind(settings).make(inputs);
    }

private:
    const ShaderKind& kind(const MaterialSettings& settings) const {
        std::string_view wanted = settings.kind;
        constexpr std::string_view plugin = "plugin:";
        if (wanted.starts_with(plugin)) wanted.remove_prefix(plugin.size());
        std::vector<std::string_view> names;
        for (const ShaderKind& k : registry_.shaders()) {
            if (k.name == wanted) return k;
            names.emplace_back(k.name);
        }
        throw Error(ErrorCode::bad_input, settings.params.where() + ": no shader \"" + std::string(wanted) + "\"" +
                                              did_you_mean(wanted, names));
    }
    std::shared_ptr<const Shader> named(std::string_view name, const MaterialSettings& user) {
        std::vector<std::string_view> names;
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
            if (scene_.materials[i].name == name) return make(i);
            names.emplace_back(scene_.materials[i].name);
        }
        throw Error(ErrorCode::bad_input,
                    user.params.where() + ": no material \"" + std::string(name) + "\"" + did_you_mean(name, names));
    }

    const Scene& scene_;
    const Registry& registry_;
    std::vector<std::shared_ptr<const Shader>> made_;
    std::vector<bool> busy_;
};

}  // namespace

std::vector<Material> make_materials(const Scene& scene, const Registry& registry) {
    if (scene.materials.empty()) {
        Scene plain;
        plain.materials.push_back({"default", "diffuse", Params(scene.file)});
        return make_materials(plain, registry);
    }
    Maker maker(scene, registry);
    std::vector<Material> materials;
    materials.reserve(scene.materials.size());
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        materials.push_back(
            {scene.materials[i].name, maker.make(i), scene.materials[i].params.colour("emission", Rgb{})});
    return materials;
}

Material ground_material(const Registry& registry) {
    Scene ground;
    ground.materials.push_back({"ground", "diffuse", Params("ground")});
    ground.materials[0].params.set("reflectance", ground_reflectance);
    return make_materials(ground, registry)[0];
}

Material black_material() { return {"lamp", std::make_shared<BlackShader>(), {}}; }

Rgb material_emission(const Material& material, const SurfacePoint& point, Vec3 wo) noexcept {
    if (dot(point.ng, wo) <= 0) return {};
    return material.emission + material.shader->emission(point, point.frame.to_local(wo));
}

bool is_emissive(const Material& material) noexcept {
    SurfacePoint point;
    point.ng = {0, 0, 1};
    return !is_black(material_emission(material, point, {0, 0, 1}));
}

}  // namespace cardioid

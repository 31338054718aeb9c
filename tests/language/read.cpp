#include "tests/language/read.hpp"

#include "formats/openscad/openscad_format.hpp"

namespace cardioid::test {
namespace {

constexpr ParamSpec diffuse_params[] = {{"reflectance", ParamType::colour, "0.5", "share that leaves"}};
constexpr ParamSpec filter_params[] = {{"reflectance", ParamType::colour, "0.5", "colour"},
                                       {"transmittance", ParamType::number, "0.5", "share that passes"}};
constexpr ParamSpec glass_params[] = {{"ior", ParamType::number, "1.5", "refractive index"}};
constexpr ParamSpec area_params[] = {{"size", ParamType::vector, "", "width and height"},
                                     {"radiance", ParamType::colour, "", "W/(sr unit^2)"}};

class SmallRegistry : public Registry {
public:
    void add(const ShaderKind&) override {}
    void add(const LightKind&) override {}
    void add(const LightingKind&) override {}
    void add(const Format&) override {}
    std::span<const ShaderKind> shaders() const override { return shaders_; }
    std::span<const LightKind> lights() const override { return lights_; }
    std::span<const LightingKind> lighting() const override { return {}; }
    std::span<const Format> formats() const override { return {}; }

private:
    std::vector<ShaderKind> shaders_{{"diffuse", "matt", diffuse_params, nullptr},
                                     {"filter", "coloured film", filter_params, nullptr},
                                     {"dielectric", "glass", glass_params, nullptr}};
    std::vector<LightKind> lights_{{"area_light", "a rectangle", area_params, nullptr},
                                   {"point_light", "a point", {}, nullptr}};
};

std::string node_text(const SolidTree& tree, std::uint32_t index) {
    static constexpr const char* names[] = {"box", "ball", "cone", "torus", "half", "prism", "revolution", "mesh"};
    const SolidNode& node = tree.nodes[index];
    if (node.op == SolidOp::leaf) return names[static_cast<std::size_t>(tree.leaves[node.first].kind)];
    const char* sign = node.op == SolidOp::unite ? "+" : node.op == SolidOp::intersect ? "&" : "-";
    std::string out = "(";
    for (std::uint32_t i = 0; i < node.count; ++i)
        out.append(i > 0 ? sign : "").append(node_text(tree, tree.children[node.first + i]));
    return out + ")";
}

}  // namespace

const Registry& small_registry() {
    static const SmallRegistry instance;
    return instance;
}

Scene read(const std::string& text, ReadOptions options) {
    if (!options.registry) options.registry = &small_registry();
    return formats::csg_format.read(text, "t.csg", options);
}

std::string error_of(const std::string& text, ReadOptions options) {
    try {
        read(text, options);
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

std::string tree_of(const Scene& scene) {
    std::string out;
    for (const std::uint32_t root : scene.solids.roots)
        out.append(out.empty() ? "" : " ").append(node_text(scene.solids, root));
    return out;
}

std::string warnings_of(const Scene& scene) {
    std::string out;
    for (const std::string& warning : scene.warnings) out += warning + "\n";
    return out;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace cardioid::test

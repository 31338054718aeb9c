#include "formats/openscad/evaluate/materials.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "rt_core/scene/nearest_name.hpp"

namespace cardioid::formats::openscad {
namespace {

MaterialSettings colour_material(const Rgba& colour) {
    MaterialSettings out{
        fmt::format("color [{:.6g}, {:.6g}, {:.6g}, {:.6g}]", colour[0], colour[1], colour[2], colour[3]),
        "diffuse",
        {}};
    if (colour[3] < 1) {
        out.kind = "filter";
        out.params.set("transmittance", 1 - colour[3]);
    }
    out.params.set("reflectance", linear_colour(colour));
    return out;
}

}  // namespace

MaterialSettings default_material() {
    MaterialSettings out{"default", "diffuse", {}};
    out.params.set("reflectance", 0.6);
    return out;
}

MaterialTable::MaterialTable(const Registry* registry, Warnings& warnings) : registry_(registry), warnings_(warnings) {
    add(default_material(), {});
}

std::uint32_t MaterialTable::add(MaterialSettings material, std::string first_used) {
    const auto index = static_cast<std::uint32_t>(materials_.size());
    by_name_.emplace(material.name, index);
    materials_.push_back(std::move(material));
    first_used_.push_back(std::move(first_used));
    return index;
}

void MaterialTable::define(const Ast& ast, const Call& call) {
    static constexpr std::string_view positional[] = {"name"};
    const Arguments args(ast, call, {positional, {}, true}, warnings_);
    // The names of the parameters are the material's own, so they are taken as they stand.
    MaterialSettings out{args.text("name"), {}, Params(args.where())};
    if (out.name.empty())
        args.wrong("name", "a text in quotes, as in define_material(\"glass\", kind = \"dielectric\")");
    for (const Argument& argument : ast.arguments_of(call)) {
        if (argument.name == Argument::no_name || argument.value.kind == ValueKind::undef) continue;
        const std::string& name = ast.texts[argument.name];
        auto value = param_value(ast, argument.value);
        if (!value) args.fail(name + " must be a number, a list of numbers, a text, true or false");
        if (name == "kind" && value->kind == ParamValue::Kind::text) out.kind = value->text;
        if (name == "kind" && out.kind.empty()) args.fail("kind must be a text in quotes");
        if (name != "kind" && name != "name") out.params.set(name, std::move(*value));
    }
    if (out.kind.empty())
        args.fail("define_material(\"" + out.name + "\") has no kind, wanted kind = \"diffuse\" or another");
    if (out.kind.starts_with("plugin:")) out.kind.erase(0, 7);
    check_kind(out, warnings_);
    const std::uint32_t index = named(out.name, {});
    if (index != 0 && !materials_[index].kind.empty())
        warnings_.add(args.where(), "material \"" + out.name + "\" is defined twice: the last counts");
    materials_[index] = std::move(out);
    first_used_[index].clear();
}

void MaterialTable::check_kind(const MaterialSettings& material, Warnings& warnings) const {
    if (!registry_) return;
    std::vector<std::string_view> kinds;
    for (const ShaderKind& kind : registry_->shaders()) {
        kinds.emplace_back(kind.name);
        if (material.kind != kind.name) continue;
        std::vector<std::string_view> names{"emission"};
        for (const ParamSpec& spec : kind.params) names.emplace_back(spec.name);
        for (const auto& [name, value] : material.params.all())
            if (std::find(names.begin(), names.end(), name) == names.end())
                warnings.once("parameter:" + material.kind + ":" + name, material.params.where(),
                              "material kind \"" + material.kind + "\" has no parameter \"" + name + "\"" +
                                  did_you_mean(name, names) + ": ignored");
        return;
    }
    std::string wanted = did_you_mean(material.kind, kinds);
    if (wanted.empty())
        for (const std::string_view kind : kinds) wanted.append(wanted.empty() ? ", wanted " : ", ").append(kind);
    throw Error(ErrorCode::bad_input,
                material.params.where() + ": no material kind \"" + material.kind + "\"" + wanted);
}

std::uint32_t MaterialTable::named(const std::string& name, const std::string& where) {
    const auto at = by_name_.find(name);
    return at != by_name_.end() ? at->second : add({name, {}, {}}, where);
}

MaterialTable::ColourKey MaterialTable::key(const Rgba& colour) {
    ColourKey out{};
    for (std::size_t i = 0; i < 4; ++i) out[i] = static_cast<std::int32_t>(std::lround(colour[i] * 1e6));  // 6 digits
    return out;
}

std::uint32_t MaterialTable::coloured(const Rgba& colour) {
    const auto [at, fresh] = by_colour_.try_emplace(key(colour), 0);
    if (fresh) {
        MaterialSettings material = colour_material(colour);
        at->second = by_name_.contains(material.name) ? by_name_.at(material.name) : add(std::move(material), {});
    }
    return at->second;
}

std::uint32_t MaterialTable::backdrop() { return coloured({0.5, 0.5, 0.5, 0.25}); }

void MaterialTable::map_colour(const Rgba& colour, const std::string& material, const std::string& where) {
    mapped_[key(colour)] = {named(material, where), where};
}

/// Nothing has a colour that map_color() names: the model's colours are told, the nearest first.
void MaterialTable::warn_of_unused(const ColourKey& colour, const std::string& where) const {
    constexpr std::size_t most_told = 3;
    const auto text = [](const ColourKey& c) {
        return fmt::format("[{:.6g}, {:.6g}, {:.6g}, {:.6g}]", c[0] * 1e-6, c[1] * 1e-6, c[2] * 1e-6, c[3] * 1e-6);
    };
    const auto distance = [&](const ColourKey& c) {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < 4; ++i) sum += std::abs(std::int64_t{c[i]} - colour[i]);
        return sum;
    };
    std::vector<ColourKey> there;
    for (const auto& [known, index] : by_colour_) there.push_back(known);
    std::stable_sort(there.begin(), there.end(),
                     [&](const ColourKey& a, const ColourKey& b) { return distance(a) < distance(b); });
    std::string has;
    for (std::size_t i = 0; i < std::min(there.size(), most_told); ++i) has += (i ? ", " : "") + text(there[i]);
    if (there.size() > most_told) has += fmt::format(" and {} more", there.size() - most_told);
    warnings_.add(where, "nothing has the colour " + text(colour) + "; the model has " + (has.empty() ? "none" : has));
}

void MaterialTable::finish(Scene& scene) {
    std::vector<std::string_view> defined;
    for (const MaterialSettings& material : materials_)
        if (!material.kind.empty()) defined.emplace_back(material.name);
    for (std::size_t i = 0; i < materials_.size(); ++i)
        if (materials_[i].kind.empty())
            throw Error(ErrorCode::bad_input, first_used_[i] + ": no material \"" + materials_[i].name + "\"" +
                                                  did_you_mean(materials_[i].name, defined));
    std::vector<std::uint32_t> to(materials_.size());
    for (std::uint32_t i = 0; i < to.size(); ++i) to[i] = i;
    for (const auto& [colour, index] : by_colour_)
        if (const auto at = mapped_.find(colour); at != mapped_.end()) to[index] = at->second.material;
    for (const auto& [colour, mapped] : mapped_)
        if (!by_colour_.contains(colour)) warn_of_unused(colour, mapped.where);
    for (Leaf& leaf : scene.solids.leaves)
        if (leaf.material != Leaf::no_material) leaf.material = to[leaf.material];
    scene.materials = std::move(materials_);
}

}  // namespace cardioid::formats::openscad

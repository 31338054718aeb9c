#include "cli/commands/lighting_choice.hpp"

#include <fmt/format.h>

#include "cli/options/values.hpp"

namespace cardioid::cli {
namespace {

std::vector<std::string> names(std::span<const LightingKind> kinds) {
    std::vector<std::string> all;
    for (const LightingKind& kind : kinds) all.emplace_back(kind.name);
    return all;
}

const LightingKind& find_kind(std::string_view option, const std::string& name, const Registry& registry) {
    for (const LightingKind& kind : registry.lighting())
        if (kind.name == name) return kind;
    const std::vector<std::string> known = names(registry.lighting());
    throw Error(ErrorCode::usage, fmt::format("{}: there is no lighting \"{}\" in this program, wanted {}{}", option,
                                              name, either(known), suggestion(name, known)));
}

const ParamSpec& find_param(const LightingKind& kind, const std::string& setting, const std::string& name) {
    std::vector<std::string> known;
    for (const ParamSpec& param : kind.params) {
        if (param.name == name) return param;
        known.emplace_back(param.name);
    }
    throw Error(ErrorCode::usage,
                fmt::format("--set {}: lighting \"{}\" has no option \"{}\"{}{}", setting, kind.name, name,
                            known.empty() ? ", nor any other" : ", wanted " + either(known), suggestion(name, known)));
}

/// Throws Error(bad_input) with the place where the scene's photons(...) names no option of the module.
void require_param(const LightingKind& kind, const Params& photons, const std::string& name) {
    std::vector<std::string> known;
    for (const ParamSpec& param : kind.params) {
        if (param.name == name) return;
        known.emplace_back(param.name);
    }
    throw Error(ErrorCode::bad_input, fmt::format("{}: photons() has no parameter \"{}\", wanted {}{}", photons.where(),
                                                  name, either(known), suggestion(name, known)));
}

ParamValue numbers(std::vector<double> values) {
    const bool list = values.size() > 1;
    return {.kind = ParamValue::Kind::numbers, .numbers = std::move(values), .list = list};
}

/// The text after '=' as the type of `spec` wants it.
ParamValue to_param(const ParamSpec& spec, const std::string& setting, const std::string& text) {
    const std::string option = "--set " + setting;
    switch (spec.type) {
        case ParamType::number:
            return numbers({to_number(option, text)});
        case ParamType::boolean:
            return {.kind = ParamValue::Kind::boolean, .boolean = to_boolean(option, text)};
        case ParamType::text:
            return {.kind = ParamValue::Kind::text, .text = text};
        case ParamType::colour:
            if (text.find(',') == std::string::npos) return numbers({to_number(option, text)});
            return numbers(to_numbers(option, text, 3, "a colour r,g,b or one number"));
        case ParamType::vector:
            return numbers(to_numbers(option, text, to_list(text).size(), "numbers with commas between"));
    }
    return {};
}

void apply_setting(const std::string& setting, const Registry& registry, LightingChoice& choice) {
    const std::size_t equals = setting.find('='), dot = setting.find('.');
    if (equals == std::string::npos || dot == std::string::npos || dot > equals)
        throw Error(ErrorCode::usage, fmt::format("--set: found \"{}\", wanted module.option=value", setting));
    const LightingKind& kind = find_kind("--set " + setting, setting.substr(0, dot), registry);
    const ParamSpec& spec = find_param(kind, setting, setting.substr(dot + 1, equals - dot - 1));
    ParamValue value = to_param(spec, setting.substr(0, equals), setting.substr(equals + 1));
    if (&kind == choice.kind)
        choice.params.set(spec.name, std::move(value));
    else
        choice.warnings.push_back(fmt::format("--set {} has no effect with --lighting {}", setting, choice.kind->name));
}

}  // namespace

LightingChoice choose_lighting(const RunOptions& options, const Scene& scene, const Registry& registry) {
    const bool photons = !options.photons.empty();
    const std::string name = !options.lighting.empty() ? options.lighting
                             : photons                 ? "photon"
                             : !scene.lighting.empty() ? scene.lighting
                                                       : "direct";
    LightingChoice choice;
    choice.kind = &find_kind(photons ? "--photons" : "--lighting", name, registry);
    choice.params = Params("--set");
    if (name == "photon")
        for (const auto& [key, value] : scene.photons.all()) {
            require_param(*choice.kind, scene.photons, key);
            choice.params.set(key, value);
        }
    if (name == "photon" && options.photon_error && !choice.params.has("error"))
        choice.params.set("error", *options.photon_error);
    if (photons && options.photons != "true")
        apply_setting(fmt::format("photon.count={}", to_count("--photons", options.photons)), registry, choice);
    for (const std::string& setting : options.settings) apply_setting(setting, registry, choice);
    return choice;
}

void end_straight_shadows(Scene& scene, LightingChoice& choice) {
    const std::string_view name = choice.kind->name;
    if (name != "photon" && name != "path") return;
    for (MaterialSettings& material : scene.materials) {
        if (material.kind != "dielectric" || !material.params.boolean("straight_shadows", false)) continue;
        material.params.set("straight_shadows", ParamValue{.kind = ParamValue::Kind::boolean, .boolean = false});
        choice.warnings.push_back(
            fmt::format("{}: straight_shadows of \"{}\" has no effect with --lighting {}, which bends that light",
                        material.params.where(), material.name, name));
    }
}

std::unique_ptr<LightingModule> make_lighting(const LightingChoice& choice, std::uint32_t seed) {
    try {
        return choice.kind->make(choice.params, seed);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::bad_input) throw;
        throw Error(ErrorCode::usage, error.what());
    }
}

}  // namespace cardioid::cli

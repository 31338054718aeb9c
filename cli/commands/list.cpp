#include <fmt/format.h>

#include "cli/builtins.hpp"
#include "cli/commands/commands.hpp"
#include "cli/io/text_output.hpp"
#include "cli/options/arguments.hpp"
#include "cli/options/values.hpp"
#include "formats/openscad/limits.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::cli {
namespace {

const char* type_name(ParamType type) {
    switch (type) {
        case ParamType::number:
            return "number";
        case ParamType::colour:
            return "colour";
        case ParamType::vector:
            return "vector";
        case ParamType::text:
            return "text";
        case ParamType::boolean:
            return "boolean";
    }
    return "";
}

std::string param_line(const std::string& prefix, const ParamSpec& param) {
    const char* const fallback = *param.fallback ? param.fallback : "(needed)";
    return fmt::format("  {:<18} {:<8} {:<16} {}\n", prefix + param.name, type_name(param.type), fallback, param.help);
}

/// A kind with its parameters under it.
template <class Kind>
std::string kinds_text(std::span<const Kind> kinds) {
    std::string text;
    for (const Kind& kind : kinds) {
        text += fmt::format("{}: {}\n", kind.name, kind.help);
        for (const ParamSpec& param : kind.params) text += param_line("", param);
    }
    return text;
}

std::string lighting_text(const Registry& registry) {
    std::string text;
    for (const LightingKind& kind : registry.lighting()) text += fmt::format("{}: {}\n", kind.name, kind.help);
    return text;
}

std::string options_text(const Registry& registry) {
    std::string text;
    for (const LightingKind& kind : registry.lighting())
        for (const ParamSpec& param : kind.params) text += param_line(std::string(kind.name) + ".", param);
    for (const ParamSpec& param : formats::openscad::limit_specs()) text += param_line("csg.", param);
    return text;
}

std::string formats_text(const Registry& registry) {
    std::string text;
    for (const Format& format : registry.formats()) {
        const std::vector<std::string> endings(format.extensions.begin(), format.extensions.end());
        const char* what = !format.write ? "read" : !format.read ? "write" : "read, write";
        text += fmt::format("{}: {} ({}; {})\n", format.name, format.help, fmt::join(endings, " "), what);
    }
    return text;
}

}  // namespace

int run_list(const std::vector<std::string>& words) {
    const std::vector<std::string> subjects{"shaders", "lights", "lighting", "formats", "options"};
    std::string subject;
    std::vector<std::string> plugins;
    Arguments arguments("list " + fmt::format("{}", fmt::join(subjects, "|")) + " [--plugin FILE]",
                        "Names what there is, plug-ins included. `options` are those of --set.");
    arguments.positional("WHAT", either(subjects), subject);
    arguments.list("--plugin", "FILE", "Load a plug-in; may be given again", plugins);
    if (!arguments.parse(words)) return 0;
    subject = to_choice("list", subject, subjects);

    const std::unique_ptr<Registry> registry = open_registry(plugins);
    print_text(subject == "shaders"    ? kinds_text(registry->shaders())
               : subject == "lights"   ? kinds_text(registry->lights())
               : subject == "lighting" ? lighting_text(*registry)
               : subject == "formats"  ? formats_text(*registry)
                                       : options_text(*registry));
    return 0;
}

}  // namespace cardioid::cli

#include <fmt/format.h>

#include "cli/builtins.hpp"
#include "cli/commands/commands.hpp"
#include "cli/io/scene_input.hpp"
#include "cli/io/text_output.hpp"
#include "cli/options/values.hpp"
#include "cli/terminal/console.hpp"

namespace cardioid::cli {
namespace {

/// The format that writes files of this ending; "-" is `.csg`. Throws Error(usage) with those there are.
const Format& find_writer(const std::string& path, const Registry& registry) {
    const std::string extension = path == "-" ? ".csg" : extension_of(path);
    std::vector<std::string> known;
    for (const Format& format : registry.formats()) {
        if (!format.write) continue;
        for (const char* name : format.extensions) {
            if (extension == name) return format;
            known.emplace_back(name);
        }
    }
    throw Error(ErrorCode::usage, fmt::format("{}: found ending \"{}\", can write {}{}", path, extension, either(known),
                                              suggestion(extension, known)));
}

}  // namespace

int run_convert(const std::vector<std::string>& words) {
    SceneOptions options;
    std::string output;
    Arguments arguments("convert SCENE -o FILE [options]", "Writes a scene in another format.");
    arguments.text("-o,--output", "FILE", "What to write; its ending tells the format, - is standard output", output);
    add_scene_options(arguments, options);
    arguments.examples("Examples:\n  cardioid convert part.scad -o part.csg\n");
    if (!arguments.parse(words)) return 0;
    if (output.empty()) throw Error(ErrorCode::usage, "no -o FILE is given; cardioid convert --help tells more");

    const std::unique_ptr<Registry> registry = open_registry(options.plugins);
    const Format& format = find_writer(output, *registry);
    keep_scene(options, output);
    check_text_path(output);
    const Scene scene = read_scene(options, *registry);
    Console console(Loudness::normal, ProgressStyle::none);
    for (const std::string& warning : scene.warnings) console.warn(warning);
    write_text(output, format.write(scene));
    return 0;
}

}  // namespace cardioid::cli

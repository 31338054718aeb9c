#include <fmt/format.h>

#include "cli/builtins.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/complete_scene.hpp"
#include "cli/io/scene_input.hpp"
#include "cli/io/text_output.hpp"
#include "cli/options/values.hpp"
#include "cli/terminal/console.hpp"
#include "cli/terminal/interrupt.hpp"

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

/// Options of `.pov` files alone.
void add_pov_options(Arguments& arguments, WriteOptions& write) {
    arguments.group("For POV-Ray (.pov)");
    arguments.flag("--photons", "Photons and radiosity, as --photons has them in our pictures", write.photons);
    arguments.value("--pov-lights", "points|area", "A lamp is K x K points, or an area_light of POV-Ray [points]",
                    [&](const std::string& text) {
                        const std::vector<std::string> choices{"points", "area"};
                        write.light_arrays = to_choice("--pov-lights", text, choices) == "area";
                    });
    arguments.value(
        "--pov-grid", "K", "Points along each side of a lamp that says nothing of it [8]",
        [&](const std::string& text) { write.light_grid = static_cast<int>(to_integer("--pov-grid", text, 1, 256)); });
}

/// Options of meshes alone.
void add_mesh_options(Arguments& arguments, WriteOptions& write) {
    arguments.group("For meshes (.stl .obj .ply .off .3mf)");
    arguments.value("--tolerance", "T",
                    "How far the mesh may be from a curved surface, in units of the scene [1e-4 of its size]",
                    [&](const std::string& text) { write.tolerance = to_number("--tolerance", text, 0); });
}

}  // namespace

int run_convert(const std::vector<std::string>& words) {
    SceneOptions options;
    WriteOptions write;
    std::string output;
    bool quiet = false;
    Arguments arguments("convert SCENE -o FILE [options]", "Writes a scene in another format.");
    arguments.text("-o,--output", "FILE", "What to write; its ending tells the format, - is standard output", output);
    add_scene_options(arguments, options);
    add_format_settings(arguments, options);
    add_pov_options(arguments, write);
    add_mesh_options(arguments, write);
    arguments.group("Messages");
    arguments.flag("-q,--quiet", "Nothing but errors", quiet);
    arguments.examples(
        "Examples:\n  cardioid convert part.scad -o part.csg\n"
        "  cardioid convert room.csg -o room.pov     the same scene for POV-Ray 3.7\n"
        "  cardioid convert part.scad -o part.stl    what it encloses as one closed mesh\n");
    if (!arguments.parse(words)) return 0;
    if (output.empty()) throw Error(ErrorCode::usage, "no -o FILE is given; cardioid convert --help tells more");

    const std::unique_ptr<Registry> registry = open_registry(options.plugins);
    const Format& format = find_writer(output, *registry);
    keep_scene(options, output);
    check_text_path(output);
    Scene scene = read_scene(options, *registry);
    // A format that is only written is for a program that does not know what we do where a scene says nothing.
    if (!format.read) complete_scene(scene, *registry);
    std::vector<std::string> notes = scene.warnings;
    write.notes = &notes;
    const Loudness loudness = quiet ? Loudness::quiet : Loudness::normal;
    Console console(loudness, progress_style("auto", loudness));
    write.progress = &console;
    catch_interrupts();  // nothing is written before all of it is there
    const std::string text = format.write(scene, write);
    for (const std::string& note : notes) console.warn(note);
    write_text(output, text);
    return 0;
}

}  // namespace cardioid::cli

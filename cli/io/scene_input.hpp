#pragma once
#include <string>
#include <vector>

#include "cli/options/arguments.hpp"
#include "rt_core/api/registry.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::cli {

/// How a scene is read; the same for every command that reads one.
struct SceneOptions {
    std::string file;       ///< "-" is standard input
    std::string base_dir;   ///< --base-dir
    std::string materials;  ///< --materials
    bool openscad_facets = false;
    int smooth_from = 24;
    bool unknown_is_warning = false;
    bool show_background = false;
    std::vector<std::string> plugins;
    std::vector<std::string> objects;   ///< named behind the file
    std::vector<std::string> settings;  ///< of formats, as FORMAT.option=value
    std::string view_file;              ///< a view script
};

/// Takes `brlcad.option=value` and `csg.option=value` out of the settings of lighting modules, and a view script out of
/// --view: a file there is, in place of a view's name.
void take_format_options(SceneOptions& options, std::vector<std::string>& settings, std::string* view);

/// Adds --set for commands that have no lighting module: options of the format alone.
void add_format_settings(Arguments& arguments, SceneOptions& options);

/// Adds SCENE under the name `positional` and the options of SceneOptions.
void add_scene_options(Arguments& arguments, SceneOptions& options, const std::string& positional = "SCENE");

/// A whole file, or standard input for "-". Throws Error(io).
std::string read_text(const std::string& file);

/// The format that reads `file`, by its extension, else by how `text` begins; null where none does.
const Format* find_reader(const std::string& file, const std::string& text, const Registry& registry);

/// Reads the scene. Throws Error(io, bad_input).
Scene read_scene(const SceneOptions& options, const Registry& registry);
/// The same of a text that is already in memory.
Scene read_scene(const SceneOptions& options, const std::string& text, const Registry& registry);

/// Throws Error(usage) where `output`, what `option` names, is the scene itself, which would be lost.
void keep_scene(const SceneOptions& options, const std::string& output, const char* option = "-o");

/// Lower-case extension with its dot, "" without one.
std::string extension_of(const std::string& file);

}  // namespace cardioid::cli

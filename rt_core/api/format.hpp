#pragma once
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rt_core/api/params.hpp"

namespace cardioid {

struct Scene;
class Progress;
class Registry;

/// What a reader is told besides the file.
struct ReadOptions {
    const Registry* registry = nullptr;  ///< which materials and lights exist
    std::string base_dir;                ///< for relative files in the scene; empty: the scene's own folder
    bool unknown_is_warning = false;     ///< --unknown=warn: an unknown call is a group of its children
    bool openscad_facets = false;        ///< --facets=openscad: everything in facets as OpenSCAD has it
    int smooth_from = 24;                ///< --smooth-from: $fn of at least this is a true curve
    bool show_background = false;        ///< --show-background: what `%` marks is drawn
    std::string materials_text;          ///< --materials: define_material and map_color calls to read before the scene
    std::string materials_file;          ///< its name, for messages
    std::vector<std::string> objects;    ///< names behind the file's: what is to be drawn of it; empty: all
    std::vector<std::pair<std::string, std::string>> settings;  ///< --set FORMAT.option=value, without the format
    std::string view_text;                                      ///< --view FILE: where the eye stands, in its language
    std::string view_file;                                      ///< its name, for messages
};

/// What a writer is told besides the scene.
struct WriteOptions {
    bool photons = false;       ///< --photons: light is to travel between surfaces, as far as the format can say so
    bool light_arrays = false;  ///< --pov-lights=area: a lamp is one light of the other program, not many points
    int light_grid = 8;         ///< --pov-grid: K, where a lamp becomes K x K points
    double tolerance = 0;       ///< --tolerance: of meshes from curved surfaces [units]; 0: 1e-4 of the scene's size
    std::vector<std::string>* notes = nullptr;  ///< gets what the format cannot express, as "file:line:column: text"
    Progress* progress = nullptr;               ///< told how far a long evaluation is, asked whether to stop
};

/// A kind of scene file in the registry.
struct Format {
    const char* name;
    const char* help;
    std::span<const char* const> extensions;  ///< ".csg", lower case
    /// Whether the first bytes of a file look like this format; null where only the extension tells.
    bool (*sniff)(std::string_view head);
    /// Fills a Scene from the text; `file` is for messages and base_dir. Throws Error. Null: cannot be read.
    Scene (*read)(const std::string& text, const std::string& file, const ReadOptions&);
    /// The scene as the text of this format. Throws Error. Null: cannot be written.
    std::string (*write)(const Scene&, const WriteOptions&);
    bool has_objects = false;  ///< ReadOptions::objects, settings and view mean something to it
};

}  // namespace cardioid

#pragma once
#include <span>
#include <string>
#include <string_view>

#include "rt_core/api/params.hpp"

namespace cardioid {

struct Scene;
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
    std::string (*write)(const Scene&);
};

}  // namespace cardioid

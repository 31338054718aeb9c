#pragma once
#include "formats/openscad/geometry/plane.hpp"

namespace cardioid::formats::openscad {

/// Whether an import() is of a drawing, not of a solid: DXF or SVG, by its ending.
bool is_plane_file(const Arguments& arguments);

/// The figure of an imported drawing. Throws Error(io) where it cannot be read, Error(bad_input) with file:line.
std::optional<Plane> plane_file(const Arguments& arguments, ShapeContext& context);

/// The figure that linear_extrude(file = ...) or rotate_extrude(file = ...) takes from a DXF; nothing without a file.
std::optional<Plane> figure_of_extrusion(const Arguments& arguments, ShapeContext& context);

/// A file named in a scene: beside the scene unless its path is absolute.
std::string path_of(const std::string& name, const ShapeContext& context);

/// The file's ending in lower case, with its dot.
std::string lower_extension(const std::string& path);

}  // namespace cardioid::formats::openscad

#pragma once
#include "formats/openscad/geometry/plane.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats::openscad {

/// Whether an import() is of a drawing, not of a solid: DXF or SVG, by its ending.
bool is_plane_file(const Arguments& arguments);

/// The figure of an imported drawing. Throws Error(bad_input) with file:line where it is damaged.
std::optional<Plane> plane_file(const Arguments& arguments, ShapeContext& context);

/// The figure that linear_extrude(file = ...) or rotate_extrude(file = ...) takes from a DXF; nothing without a file.
std::optional<Plane> figure_of_extrusion(const Arguments& arguments, ShapeContext& context);

/// For what was caught reading a file that a call names: one that is not there is a warning, and nothing is made of it,
/// as in OpenSCAD; for any other fault throws it again with the place of the call.
void pass_over(const Error& error, const Arguments& arguments, ShapeContext& context);

/// A file named in a scene: beside the scene unless its path is absolute.
std::string path_of(const std::string& name, const ShapeContext& context);

/// The file's ending in lower case, with its dot.
std::string lower_extension(const std::string& path);

}  // namespace cardioid::formats::openscad

#pragma once
#include "formats/openscad/geometry/solids.hpp"

namespace cardioid::formats::openscad {

/// surface(file, center, invert): a height map from a text of numbers or from a picture, as OpenSCAD 2021.01 has it.
/// Throws Error(io) where the file cannot be read, Error(bad_input) with file:line.
std::optional<Shape> make_surface(const Arguments& arguments, ShapeContext& context);

}  // namespace cardioid::formats::openscad

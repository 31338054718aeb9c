#pragma once
#include "formats/openscad/geometry/plane.hpp"

namespace cardioid::formats::openscad {

/// The figure of a text() call; a warning where its font is not installed. Nothing where there is nothing to see.
std::optional<Plane> text_figure(const Arguments& arguments, ShapeContext& context);

}  // namespace cardioid::formats::openscad

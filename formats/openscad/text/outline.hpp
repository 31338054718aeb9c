#pragma once
#include "formats/openscad/text/font.hpp"
#include "rt_core/scene/solid.hpp"

namespace cardioid::formats::openscad {

/// A glyph's contours in units of text of size 1, and its box on FreeType's pixel grid [font units].
struct Outline {
    Profile figure;
    double left = 0, right = 0, bottom = 0, top = 0;
};

/// A glyph by its number, each curve of its outline as `segments` lines; empty where the font cannot draw it.
Outline draw_glyph(FT_Face face, unsigned glyph, int segments);

}  // namespace cardioid::formats::openscad

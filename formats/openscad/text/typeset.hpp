#pragma once
#include <string>

#include "rt_core/scene/solid.hpp"

namespace cardioid::formats::openscad {

/// What text() is told.
struct Typeset {
    std::string text;                 ///< UTF-8
    std::string font;                 ///< a fontconfig name, "DejaVu Sans:style=Bold"; empty: Liberation Sans
    std::string direction = "ltr";    ///< "ltr", "rtl", "ttb", "btt"
    std::string language = "en";      ///< as HTML's lang
    std::string script;               ///< ISO 15924; empty: that of the text
    std::string halign = "left";      ///< "left", "center", "right"
    std::string valign = "baseline";  ///< "top", "center", "baseline", "bottom"
    double size = 10, spacing = 1;    ///< height of capitals, roughly; of advances
    int segments = 2;                 ///< lines an outline's curve becomes
};

/// Glyphs as figures, to be united; each read by the non-zero rule of its font's outlines.
struct Glyphs {
    std::vector<Profile> figures;
    std::string missing_font;  ///< the name that was asked for and is not installed
    std::string used_font;     ///< the family in its place
};

/// Sets a text as OpenSCAD 2021.01 does: fontconfig finds the font, HarfBuzz shapes, FreeType draws. Throws Error(io)
/// where no font at all is installed, Error(bad_input) for a text that is not UTF-8. Any thread may call it.
Glyphs typeset(const Typeset& what);

}  // namespace cardioid::formats::openscad

#pragma once
#include <pugixml.hpp>

#include "rt_core/math/affine.hpp"

namespace cardioid::formats {

/// How a drawing's own units become those of the scene: lengths in millimetres, y up.
struct SvgPage {
    Vec2d scale{1, 1};  ///< of the drawing's units
    Vec2d align;        ///< where a view box stands within its page [mm]
    Vec2d view_box;     ///< corner of the view box [drawing's units]
    double height = 0;  ///< of the page [mm]
};

/// Width, height, viewBox and preserveAspectRatio of the root (SVG 1.1, section 7), as OpenSCAD 2021.01 reads them.
SvgPage read_svg_page(const pugi::xml_node& svg, double dpi);

/// A `transform` attribute (SVG 1.1, section 7.6).
Affine parse_svg_transform(const char* text);

}  // namespace cardioid::formats

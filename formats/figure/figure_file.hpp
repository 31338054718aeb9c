#pragma once
#include <string>

#include "csg/shapes/facets.hpp"
#include "rt_core/scene/solid.hpp"

namespace cardioid::formats {

/// How OpenSCAD's import() wants a drawing.
struct FigureOptions {
    std::string layer;          ///< of a DXF; empty: all
    Vec2d origin;               ///< of a DXF: its point that becomes the origin
    double scale = 1;           ///< of a DXF
    double dpi = 72;            ///< of an SVG: its pixels an inch
    bool centre = false;        ///< of an SVG: its middle becomes the origin
    csg::FacetSettings facets;  ///< for arcs
    bool smooth = false;        ///< arcs as fine as a picture wants them, whatever the facets say
};

/// A drawing: figures to be united, each by the even-odd rule; and what in it could not be read.
struct FigureFile {
    std::vector<Profile> figures;
    std::vector<std::string> warnings;
};

/// Throws Error(bad_input) with file:line.
FigureFile read_dxf(std::string_view text, const std::string& file, const FigureOptions& options);
FigureFile read_svg(std::string_view text, const std::string& file, const FigureOptions& options);

/// Lines that an arc of `sweep` [radians] and radius r becomes; at least 1.
int arc_steps(double r, double sweep, const FigureOptions& options);

}  // namespace cardioid::formats

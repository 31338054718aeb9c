#pragma once
#include <vector>

#include "formats/openscad/geometry/plane.hpp"

namespace cardioid::formats::openscad {

/// An extrusion as shapes: `body`, and what is cut from it or must be common to it.
struct Extrusion {
    std::optional<Shape> body;
    std::vector<Shape> wedge;  ///< half-spaces whose intersection is ...
    bool keep_wedge = true;    ///< ... all that is kept of the body, or (false) taken from it
};

/// linear_extrude of the union of `parts`. Analytic where it can be: a true circle makes a cone, a profile of few edges
/// a prism; what is twisted or scaled unevenly becomes a mesh of OpenSCAD's slices.
Extrusion linear_extrusion(std::span<const Plane> parts, const Arguments& arguments, ShapeContext& context);

/// The union of `parts` as a plate one unit thick about z = 0, as OpenSCAD's preview draws it. where: for warnings.
std::optional<Shape> plate(std::span<const Plane> parts, const std::string& where, ShapeContext& context);

/// rotate_extrude of the union of `parts`. True curves: a torus or a revolution, cut by half-spaces below 360 degrees.
Extrusion rotate_extrusion(std::span<const Plane> parts, const Arguments& arguments, ShapeContext& context);

/// roof of the union of `parts`, as later versions of OpenSCAD have it.
Extrusion roof(std::span<const Plane> parts, const Arguments& arguments, ShapeContext& context);

}  // namespace cardioid::formats::openscad

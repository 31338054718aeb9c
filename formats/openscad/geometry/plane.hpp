#pragma once
#include <optional>
#include <span>
#include <vector>

#include "formats/openscad/geometry/solids.hpp"

namespace cardioid::formats::openscad {

/// A plane figure while its tree is evaluated, in the plane of the extrusion around it.
struct Plane {
    Profile profile;
    bool clean = false;            ///< contours do not cross and are turned as Profile says
    std::optional<Affine> circle;  ///< a true circle: carries the unit circle here; `profile` is then empty
};

/// Corners of a true circle where a polygon must stand for it: chord error 1 - cos(pi / 224) < 1e-4 of the radius.
inline constexpr int fine_circle = 224;

/// The figure of a square, circle or polygon, carried by `map`; nothing, and a warning, where it is empty.
std::optional<Plane> make_plane(Node node, const Arguments& arguments, const Affine& map, ShapeContext& context);

/// The contours of a figure, those of a true circle with fine_circle corners, to be read by the even-odd rule.
Profile as_profile(const Plane& plane);

/// The figure carried by a map of the plane; nothing, and a warning, where that leaves nothing of it.
std::optional<Plane> carried(Plane plane, const Affine& map, const Arguments& arguments, ShapeContext& context);

/// Clipper's grid for figures with coordinates up to `largest`.
double grid_of(double largest, const ReadOptions& options);

/// Union of the figures; Clipper's grid is OpenSCAD's in facets mode, else relative to their size.
Plane unite(std::span<const Plane> parts, const ShapeContext& context);
Plane intersect(std::span<const Plane> parts, const ShapeContext& context);
/// The first without the rest.
Plane subtract(std::span<const Plane> parts, const ShapeContext& context);

/// The figure with contours that do not cross; empty where it has no area.
Profile contours_of(const Plane& plane, const ShapeContext& context);

/// If no two edges touch or cross (tested up to most_profile_edges): turns the contours as Profile says, moves no
/// point, and is true.
bool orient_if_simple(Profile& profile);

}  // namespace cardioid::formats::openscad

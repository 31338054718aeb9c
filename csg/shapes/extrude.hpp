#pragma once
#include "csg/shapes/facets.hpp"
#include "rt_core/scene/profile.hpp"
#include "rt_core/scene/triangle_mesh.hpp"

namespace cardioid::csg {

struct LinearExtrusion {
    double height = 100;
    bool centre = false;
    double twist_deg = 0;  ///< clockwise, as OpenSCAD
    int slices = 0;        ///< 0: as OpenSCAD derives them
    Vec2d scale{1, 1};     ///< of the top; 0 gives a point or an edge
    FacetSettings facets;
};

/// Slices that OpenSCAD 2021.01 derives from height, twist, scale and facet settings where none are given; at least 1.
int slice_count(const Profile& profile, const LinearExtrusion& how);

/// The extrusion as a closed mesh, with OpenSCAD 2021.01's slices and choice of diagonals. Empty where the height is
/// not positive and finite; a negative scale counts as 0. Where one scale is 0 the top may hold triangles of no area,
/// which close the mesh. Throws Error(limit) past 2^32 corners.
TriangleMesh linear_extrude(const Profile& profile, const LinearExtrusion& how);

/// Turned about z, profile x -> radius, y -> z, in `n` steps from `start` as OpenSCAD 2021.01 (360 degrees start at -x,
/// others at +x). angle_deg in (-360, 360], else 360; 0 gives nothing. Throws Error(bad_input) where the profile does
/// not lie on one side of x = 0, and Error(limit) past 2^32 corners.
TriangleMesh rotate_extrude(const Profile& profile, double angle_deg, const FacetSettings& facets);

/// A roof of 45 degrees over a figure whose contours do not cross, turned as Profile says: as high as the nearest point
/// of the edge is far, its cones having `corners` sides around; or, where that is 0, with a plane over each edge (the
/// straight skeleton: Aichholzer et al., 1995), which is the same where no corner turns inwards. Curved corners move
/// the edge by less than 1e-5 of the figure's size. O(n^2). Throws Error(bad_input) where contours touch.
TriangleMesh roof(const Profile& profile, int corners);

}  // namespace cardioid::csg

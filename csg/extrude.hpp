#pragma once
#include "csg/facets.hpp"
#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

struct LinearExtrusion {
    double height = 100;
    bool centre = false;
    double twist_deg = 0;  ///< clockwise, as OpenSCAD
    int slices = 0;        ///< 0: as OpenSCAD derives them
    Vec2d scale{1, 1};     ///< of the top; 0 gives a point or an edge
    FacetSettings facets;
};

/// The extrusion as a closed mesh, with OpenSCAD 2021.01's slices and choice of diagonals.
TriangleMesh linear_extrude(const Profile& profile, const LinearExtrusion& how);

/// Turned about z, profile x -> radius, y -> z, in `n` steps from `start` as OpenSCAD 2021.01 (360 degrees start at -x,
/// others at +x). angle_deg in (-360, 360]. The profile must lie on one side of x = 0.
TriangleMesh rotate_extrude(const Profile& profile, double angle_deg, const FacetSettings& facets);

}  // namespace cardioid::csg

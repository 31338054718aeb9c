#pragma once
#include <vector>

#include "rt_core/scene/triangle_mesh.hpp"

namespace cardioid::csg {

/// OpenSCAD's $fn, $fa [degrees], $fs [units].
struct FacetSettings {
    double fn = 0, fa = 12, fs = 2;
};

/// Segments of a circle of radius r as OpenSCAD 2021.01 counts them; at least 3.
int facet_count(double r, const FacetSettings& settings);

/// Corners of a regular n-gon, corner k at angle 360 k / n from +x; cosines of multiples of 30 and 45 degrees are
/// exact.
std::vector<Vec2d> circle_points(double r, int n);

/// OpenSCAD's sphere: (n + 1) / 2 rings of n corners at polar angles 180 (i + 1/2) / rings, flat caps.
TriangleMesh faceted_sphere(double r, int n);

/// OpenSCAD's cylinder, z from 0 to h; one of the radii may be 0.
TriangleMesh faceted_cone(double h, double r1, double r2, int n);

}  // namespace cardioid::csg

#pragma once
#include "formats/openscad/evaluate/arguments.hpp"
#include "formats/openscad/evaluate/call_table.hpp"
#include "rt_core/math/affine.hpp"

namespace cardioid::formats::openscad {

/// The map of multmatrix, translate, rotate, scale or mirror as OpenSCAD defines it; may be singular or not finite.
Affine transform_of(Node node, const Arguments& arguments);

/// What the same map does to a plane figure: its upper left 2x2 part and the translation in x and y.
Affine in_plane(const Affine& m);

/// Whether the map flattens what it is applied to, whatever its scale, or is not finite.
bool is_singular(const Affine& m);

/// Whether what the map places is larger or farther away than single precision can trace (1e15).
bool is_out_of_reach(const Affine& m);

/// The rotation by an angle about z, exact at multiples of 30 and 45 degrees.
Affine rotation_z(double degrees);

/// A rotation that carries +z to the direction of n (not zero); the identity for +z.
Affine rotation_to(Vec3d n);

}  // namespace cardioid::formats::openscad

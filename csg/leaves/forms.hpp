#pragma once
/// Leaves that are given by a formula: LeafKind::form.
#include "csg/leaves/leaf.hpp"

namespace cardioid::csg {

/// The smallest box around a form in its own space.
Box3d form_box(const Form& form);

/// Appends the events of the line o + t d in local space: even in number and sorted, whatever rounding does, because a
/// crossing is a change of sign between two ends that are both outside, or on a flat face.
void append_form(const Form& form, std::uint32_t index, Vec3d o, Vec3d d, EventList& out);

/// Out of the form at p on `face`, in local space, of any length.
Vec3d form_normal(const Form& form, std::uint32_t face, Vec3d p);

/// Below 0 inside, in the form's box; the flat faces of the box are not in it.
double form_value(const Form& form, Vec3d p);

/// A superellipsoid's own measure of a vector: 1 on its surface; where n and e are at most 2 a norm, so
/// convex along every line.
double superellipsoid_norm(const Form& form, Vec3d p);

}  // namespace cardioid::csg

#pragma once
#include <span>

#include "rt_core/math/affine.hpp"
#include "rt_core/scene/profile.hpp"

namespace cardioid::csg {

enum class ProfileOp { unite, intersect, subtract };

/// Boolean of plane figures by Clipper: the first with each of the rest; every one is first sanitised by the even-odd
/// rule. Coordinates are truncated to multiples of `grid` (OpenSCAD 2021.01: 2^-16; taken down to a power of two), or
/// of a coarser grid where they would leave Clipper's range. Contours with a coordinate that is not finite are left
/// out. One part alone is only sanitised. OpenSCAD does not snap a circle or square that meets no other figure. Throws
/// Error(bad_input) where Clipper fails.
Profile profile_boolean(ProfileOp op, std::span<const Profile> parts, double grid);

/// The figure mapped by the upper left 2x2 part and the translation of `m`; orientation is kept.
Profile transformed(const Profile& profile, const Affine& m);

/// Whether p is inside, by the even-odd rule.
bool contains(const Profile& profile, Vec2d p);

}  // namespace cardioid::csg

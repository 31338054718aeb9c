#pragma once
#include "rt_core/scene/profile.hpp"

namespace cardioid::csg {

enum class Corner {
    round,   ///< an arc about the old corner
    mitre,   ///< the edges run on until they meet
    chamfer  ///< cut off at the offset's distance
};

/// The figure grown by `distance`, or shrunk where that is below 0, as OpenSCAD 2021.01 (Clipper). arc_corners:
/// corners of a whole circle where corners are round. Grid as profile_boolean.
Profile profile_offset(const Profile& profile, double distance, Corner corner, double arc_corners, double grid);

/// The Minkowski sum of two figures: all sums of a point of the one and a point of the other.
Profile profile_minkowski(const Profile& a, const Profile& b, double grid);

enum class LineEnd { butt, square, round };

/// An open line with a width, its corners mitred, on a grid of 1e-4 (as OpenSCAD 2021.01 draws strokes).
Profile widened_line(const std::vector<Vec2d>& points, double width, LineEnd end);

/// The figure by the non-zero rule: overlapping contours of one direction are united.
Profile by_winding(const Profile& profile, double grid);

/// The figure without its holes.
Profile without_holes(const Profile& profile, double grid);

}  // namespace cardioid::csg

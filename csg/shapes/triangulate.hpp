#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "rt_core/scene/profile.hpp"

namespace cardioid::csg {

/// A plane figure filled with triangles. Contours that touch or cross are cut where they do, so that each boundary edge
/// of the triangles is an edge of `contours`, as often as the even-odd rule makes it one.
struct FilledProfile {
    std::vector<Vec2d> points;  ///< those of the profile, concatenated; then those where contours cross
    std::vector<std::vector<std::uint32_t>> contours;     ///< into points; equal points have the first one's index
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise, no two corners equal
};

/// Constrained Delaunay triangulation of the inside by the even-odd rule; O(n log n). Points must be finite. A contour
/// without area leaves its points and edges, and no triangle.
FilledProfile fill(const Profile& profile);

}  // namespace cardioid::csg

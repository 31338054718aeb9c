#pragma once
#include <cstdint>
#include <span>

#include "rt_core/api/math.hpp"

namespace cardioid::photon {

/// A point of the plane, and which one it was in the caller's list.
struct PlanePoint {
    float x, y;
    std::uint32_t index;
    [[nodiscard]] Vec2 p() const { return {x, y}; }
};

struct Hull {
    std::span<PlanePoint> corners;  ///< the strict corners, counter-clockwise, at the beginning of the points
    float area = 0;                 ///< 0 where the points lie on a line
    /// How far q lies outside of the side that it lies outside of most; negative within. Infinite without an area.
    [[nodiscard]] float outside(Vec2 q) const noexcept;
};

/// The convex hull of points, which are reordered (Andrew 1979, monotone chain); O(n log n). `room` has a place more
/// than there are points, and the hull's corners stay in it.
[[nodiscard]] Hull convex_hull(std::span<PlanePoint> points, std::span<PlanePoint> room) noexcept;

}  // namespace cardioid::photon

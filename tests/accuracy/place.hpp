#pragma once
#include "rt_core/render/probe.hpp"

namespace cardioid::test {

/// Where a value is measured: at a point, or as the mean over evenly distributed points of a set.
struct Place {
    enum class Kind {
        point,      ///< origin, along
        rectangle,  ///< origin + s u + t v, along
        disc,       ///< around origin, with the normal `along`
        sphere,     ///< around origin, with normals outwards (side 1) or inwards (-1)
        room,       ///< the inner faces of the box from origin to u
        view        ///< rays from `along` to the points of the rectangle; their mean is over its area
    } kind = Kind::point;
    Quantity what = Quantity::irradiance;
    Vec3d origin, u, v, along;
    double radius = 0, side = 1;

    [[nodiscard]] bool single() const { return kind == Kind::point; }
    /// The point of the set for r in [0, 1)^2: uniform r, uniform points.
    [[nodiscard]] ProbePoint at(Vec2d r) const;
};

}  // namespace cardioid::test

#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "rt_core/math/vec.hpp"

namespace cardioid {

/// Triangles, counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<Vec3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool closed = false;  ///< every edge is shared by two triangles that run it in opposite directions
};

}  // namespace cardioid

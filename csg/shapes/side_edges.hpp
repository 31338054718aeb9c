#pragma once
#include <vector>

#include "csg/shapes/triangulate.hpp"
#include "rt_core/scene/triangle_mesh.hpp"

namespace cardioid::csg {

/// A border edge of a filled figure, run with the figure on its left.
struct SideEdge {
    std::uint32_t from, to;  ///< into FilledProfile::points
    bool outer;              ///< of an outer contour, not of a hole
};

/// The border edges along the contours; what no fill lies beside, or fill lies on both sides of, is no border.
std::vector<SideEdge> side_edges(const FilledProfile& filled);

/// Adds the figure's triangles over vertices that begin at `first`, as they are or turned over.
void append_cap(TriangleMesh& mesh, const FilledProfile& filled, std::size_t first, bool as_filled);

/// Throws Error(limit) where corners cannot be numbered by 32 bits.
void check_corner_count(double corners);

}  // namespace cardioid::csg

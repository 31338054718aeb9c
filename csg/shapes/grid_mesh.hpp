#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "rt_core/scene/triangle_mesh.hpp"

namespace cardioid::csg {

/// How the four corners of a cell of a height field become two triangles.
enum class CellCut : unsigned char {
    rising,   ///< along (0, 0) - (1, 1)
    falling,  ///< along (1, 0) - (0, 1)
    adaptive  ///< the one of the two along which the heights bend less, with the samples behind its ends; else falling
};

/// The solid between z = 0 and heights over the points (x, y) of a grid of unit cells, `width` heights a row; where a
/// triangle lies at 0 there is none. Closed. Empty where the grid has no cell. Heights are not negative.
TriangleMesh height_mesh(const std::vector<double>& heights, std::size_t width, CellCut cut);

/// The union of unit cells of a grid of w x n x d, those where `full(x, y, z)`, as the faces between full and empty
/// ones. Closed; edges where cells touch without a face in common have four triangles. Empty, with `too_many` set,
/// where it has more than `most` faces.
struct CellMesh {
    TriangleMesh mesh;
    bool too_many = false;
};
CellMesh cell_mesh(std::size_t w, std::size_t n, std::size_t d,
                   const std::function<bool(std::size_t, std::size_t, std::size_t)>& full, std::size_t most);

}  // namespace cardioid::csg

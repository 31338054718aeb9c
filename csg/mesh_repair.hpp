#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

/// What is wrong with a mesh, for `check` and warnings.
struct MeshFaults {
    std::size_t open_edges = 0;     ///< edges with one triangle
    std::size_t crowded_edges = 0;  ///< edges with more than two, or two that run it the same way
    std::size_t dropped_faces = 0;  ///< bad index, fewer than three different corners
    std::size_t non_planar_faces = 0;
    bool inside_out = false;   ///< its volume was negative; it was turned
    std::vector<Vec3d> where;  ///< middles of the first few open edges
    [[nodiscard]] bool closed() const { return open_edges == 0 && crowded_edges == 0; }
};

/// Polygon faces (indices, clockwise seen from outside, as OpenSCAD writes them) as triangles; faces with more than
/// three corners by constrained Delaunay triangulation in their plane. Faces of bad indices are left out and counted.
TriangleMesh triangulate_polyhedron(const std::vector<Vec3d>& points,
                                    const std::vector<std::vector<std::uint32_t>>& faces, MeshFaults& faults);

/// Welds equal vertices, drops triangles of no area, turns an inside-out mesh, sets `closed`, counts what is left
/// wrong.
MeshFaults repair(TriangleMesh& mesh);

/// Signed volume; of a closed mesh only it means something.
double volume(const TriangleMesh& mesh);

/// Triangles (counter-clockwise) that fill a profile, over the concatenated points of its contours.
std::vector<std::array<std::uint32_t, 3>> triangulate(const Profile& profile);

}  // namespace cardioid::csg

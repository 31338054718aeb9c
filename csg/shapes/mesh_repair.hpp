#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "rt_core/scene/profile.hpp"
#include "rt_core/scene/triangle_mesh.hpp"

namespace cardioid::csg {

/// What is wrong with a mesh, for `check` and warnings.
struct MeshFaults {
    std::size_t open_edges = 0;        ///< edges with one triangle
    std::size_t crowded_edges = 0;     ///< edges with more than one, which do not pair up in opposite directions
    std::size_t dropped_faces = 0;     ///< bad index, corner not finite, fewer than three different corners
    std::size_t non_planar_faces = 0;  ///< the solid depends on how they are cut into triangles
    bool inside_out = false;           ///< its volume was negative; it was turned
    std::vector<Vec3d> where;          ///< middles of the first few open edges
    [[nodiscard]] bool closed() const { return open_edges == 0 && crowded_edges == 0; }
};

/// Polygon faces (indices, clockwise seen from outside, as OpenSCAD writes them) as triangles; faces with more than
/// three corners by constrained Delaunay triangulation in their plane. Faces of bad indices are left out and counted.
TriangleMesh triangulate_polyhedron(const std::vector<Vec3d>& points,
                                    const std::vector<std::vector<std::uint32_t>>& faces, MeshFaults& faults);

/// Welds equal vertices, leaves out unused ones, drops triangles with fewer than three different corners, sets
/// `closed`, counts what is left wrong. A triangle of no area whose corners differ stays, as it may close the mesh.
/// O(n).
MeshFaults weld(TriangleMesh& mesh);

/// As weld; and turns triangles that run against most of their neighbours, and a closed mesh that is inside out.
MeshFaults repair(TriangleMesh& mesh);

/// Signed volume; of a closed mesh only it means something.
double volume(const TriangleMesh& mesh);

/// Triangles (counter-clockwise) that fill a profile, over the concatenated points of its contours. Throws
/// Error(bad_input) where contours cross; see csg/shapes/triangulate.hpp for those.
std::vector<std::array<std::uint32_t, 3>> triangulate(const Profile& profile);

}  // namespace cardioid::csg

#pragma once
#include <span>
#include <vector>

#include "rt_core/scene/solid.hpp"

namespace cardioid::formats {

/// Gathers a file's corners and faces. Throws Error(limit) past 2^32 corners.
class MeshBuilder {
public:
    /// p must be finite.
    void add_vertex(Vec3d p);
    /// Corners counter-clockwise seen from outside; indices are checked by the caller. Fewer than three are left out.
    void add_face(std::span<const std::uint32_t> corners);
    void reserve(std::size_t vertices, std::size_t triangles);

    [[nodiscard]] std::size_t vertex_count() const { return mesh_.vertices.size(); }
    [[nodiscard]] bool has_faces() const { return !mesh_.triangles.empty() || !polygons_.empty(); }
    /// The triangles, and the polygons cut into triangles after them.
    TriangleMesh finish();

private:
    TriangleMesh mesh_;
    std::vector<std::vector<std::uint32_t>> polygons_;  ///< clockwise, as csg::triangulate_polyhedron wants them
};

}  // namespace cardioid::formats

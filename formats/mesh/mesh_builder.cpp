#include "formats/mesh/mesh_builder.hpp"

#include <limits>

#include "csg/shapes/mesh_repair.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats {

void MeshBuilder::add_vertex(Vec3d p) {
    if (mesh_.vertices.size() >= std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorCode::limit, "a mesh with more than 2^32 corners");
    mesh_.vertices.push_back(p);
}

void MeshBuilder::add_face(std::span<const std::uint32_t> corners) {
    if (corners.size() == 3) mesh_.triangles.push_back({corners[0], corners[1], corners[2]});
    if (corners.size() > 3) polygons_.emplace_back(corners.rbegin(), corners.rend());
}

void MeshBuilder::reserve(std::size_t vertices, std::size_t triangles) {
    mesh_.vertices.reserve(vertices);
    mesh_.triangles.reserve(triangles);
}

TriangleMesh MeshBuilder::finish() {
    csg::MeshFaults faults;
    if (polygons_.empty()) return std::move(mesh_);
    const TriangleMesh cut = csg::triangulate_polyhedron(mesh_.vertices, polygons_, faults);
    mesh_.triangles.insert(mesh_.triangles.end(), cut.triangles.begin(), cut.triangles.end());
    return std::move(mesh_);
}

}  // namespace cardioid::formats

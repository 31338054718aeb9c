#include "csg/shapes/mesh_repair.hpp"

#include <algorithm>
#include <bit>

#include "csg/shapes/mesh_edges.hpp"
#include "rt_core/math/sampler.hpp"

namespace cardioid::csg {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

/// Finds equal points: an open hash table of vertex indices, at most half full.
class PointTable {
public:
    explicit PointTable(std::size_t points) : slots_(std::bit_ceil(2 * points + 2), none) {}

    /// The index of p among `points`, to which it is added where it is new.
    std::uint32_t find_or_add(Vec3d p, std::vector<Vec3d>& points) {
        p += Vec3d{0, 0, 0};  // -0 becomes 0
        std::uint64_t hash = mix64(std::bit_cast<std::uint64_t>(p.x));
        hash = mix64(hash ^ std::bit_cast<std::uint64_t>(p.y));
        hash = mix64(hash ^ std::bit_cast<std::uint64_t>(p.z));
        for (std::size_t i = hash & (slots_.size() - 1);; i = (i + 1) & (slots_.size() - 1)) {
            if (slots_[i] == none) {
                slots_[i] = static_cast<std::uint32_t>(points.size());
                points.push_back(p);
                return slots_[i];
            }
            if (points[slots_[i]] == p) return slots_[i];
        }
    }

private:
    std::vector<std::uint32_t> slots_;
};

bool has_three_corners(const std::array<std::uint32_t, 3>& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; }

/// Welds and drops; returns the number of dropped triangles.
std::size_t weld_vertices(TriangleMesh& mesh) {
    std::vector<Vec3d> points;
    std::vector<std::uint32_t> moved(mesh.vertices.size(), none);
    PointTable table(mesh.vertices.size());
    std::size_t kept = 0;
    for (std::array<std::uint32_t, 3> triangle : mesh.triangles) {
        const bool usable = std::ranges::all_of(
            triangle, [&](std::uint32_t v) { return v < mesh.vertices.size() && is_finite(mesh.vertices[v]); });
        if (!usable) continue;
        for (std::uint32_t& v : triangle) {
            if (moved[v] == none) moved[v] = table.find_or_add(mesh.vertices[v], points);
            v = moved[v];
        }
        if (has_three_corners(triangle)) mesh.triangles[kept++] = triangle;
    }
    const std::size_t dropped = mesh.triangles.size() - kept;
    mesh.triangles.resize(kept);
    mesh.vertices = std::move(points);
    return dropped;
}

void count_edges(const TriangleMesh& mesh, MeshFaults& faults) {
    constexpr std::size_t most_places = 8;
    faults.open_edges = faults.crowded_edges = 0;
    faults.where.clear();
    for_each_edge(mesh, [&](std::uint32_t a, std::uint32_t b, std::span<const HalfEdge> sides) {
        std::size_t forward = 0;
        for (const HalfEdge& side : sides) forward += side.forward;
        if (sides.size() == 1) {
            ++faults.open_edges;
            if (faults.where.size() < most_places) faults.where.push_back((mesh.vertices[a] + mesh.vertices[b]) * 0.5);
        } else if (2 * forward != sides.size()) {
            ++faults.crowded_edges;
        }
    });
}

void turn(std::array<std::uint32_t, 3>& triangle) { std::swap(triangle[1], triangle[2]); }

}  // namespace

MeshFaults weld(TriangleMesh& mesh) {
    MeshFaults faults;
    faults.dropped_faces = weld_vertices(mesh);
    count_edges(mesh, faults);
    mesh.closed = faults.closed();
    return faults;
}

MeshFaults repair(TriangleMesh& mesh) {
    MeshFaults faults = weld(mesh);
    if (faults.crowded_edges > 0) {
        for (const std::uint32_t t : misturned_triangles(mesh)) turn(mesh.triangles[t]);
        count_edges(mesh, faults);
        mesh.closed = faults.closed();
    }
    if (mesh.closed && volume(mesh) < 0) {
        for (auto& triangle : mesh.triangles) turn(triangle);
        faults.inside_out = true;
    }
    return faults;
}

double volume(const TriangleMesh& mesh) {
    if (mesh.vertices.empty()) return 0;
    const Vec3d from = mesh.vertices[0];  // a point of the mesh itself: no digits are lost far from the origin
    double six_volumes = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        six_volumes += dot(mesh.vertices[a] - from, cross(mesh.vertices[b] - from, mesh.vertices[c] - from));
    return six_volumes / 6;
}

}  // namespace cardioid::csg

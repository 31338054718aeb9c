#include <algorithm>
#include <cmath>
#include <numeric>

#include "csg/shapes/mesh_repair.hpp"
#include "csg/shapes/triangulate.hpp"

namespace cardioid::csg {

namespace {

using Face = std::vector<std::uint32_t>;

/// A face dropped onto the coordinate plane it is most nearly parallel to: no coordinate changes, so collinear corners
/// stay exactly collinear. Runs counter-clockwise.
struct Shadow {
    std::vector<Vec2d> corners;
    Vec3d normal;          ///< Newell's, twice the area long
    double out_of_plane;   ///< greatest distance of a corner from the plane of best fit
    double largest_digit;  ///< greatest size of a coordinate
};

/// Newell's method (Tampieri, Graphics Gems III, 1992): exact for planar polygons, best fit for others.
Vec3d newell_normal(const std::vector<Vec3d>& points, const Face& face) {
    Vec3d normal;
    const Vec3d from = points[face[0]];
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        normal += cross(points[face[i]] - from, points[face[i + 1]] - from);
    return normal;
}

Shadow shadow_of(const std::vector<Vec3d>& points, const Face& face) {
    Shadow out{{}, newell_normal(points, face), 0, 0};
    const Vec3d size = abs(out.normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double sign = out.normal[axis] < 0 ? -1 : 1;
    Vec3d middle;
    for (const std::uint32_t i : face) middle += points[i] / static_cast<double>(face.size());
    const double area = length(out.normal);
    for (const std::uint32_t i : face) {
        out.corners.push_back({points[i][u], sign * points[i][v]});
        if (area > 0)
            out.out_of_plane = std::max(out.out_of_plane, std::abs(dot(points[i] - middle, out.normal)) / area);
        out.largest_digit = std::max(out.largest_digit, max_component(abs(points[i])));
    }
    return out;
}

bool is_planar(const Shadow& shadow) {
    constexpr double rounding = 1e-5;  // of coordinates that were printed with 6 digits
    return shadow.out_of_plane <= rounding * shadow.largest_digit;
}

/// Of a convex quad on a circle OpenSCAD's sweep from left to right takes the diagonal through the second corner.
int sweep_diagonal(const std::vector<Vec2d>& c) {
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(c[i].x, c[i].y); });
    return order[1] % 2 == 0 ? 0 : 1;
}

/// Where the four corners are strictly convex, the diagonal that Delaunay's rule takes: 0 for that of the first corner,
/// 1 for the other; -1 for all other shapes.
int quad_diagonal(const std::vector<Vec2d>& c) {
    for (std::size_t i = 0; i < 4; ++i)
        if (!(cross(c[(i + 1) % 4] - c[i], c[(i + 2) % 4] - c[(i + 1) % 4]) > 0)) return -1;
    // Two opposite angles that sum to less than pi are not joined by Delaunay's diagonal: the sine of the sum tells.
    const Vec2d a = c[1] - c[0], b = c[3] - c[0], d = c[3] - c[2], e = c[1] - c[2];
    const double sine = cross(a, b) * dot(d, e) + dot(a, b) * cross(d, e);
    const double rounding = 1e-12 * length(a) * length(b) * length(d) * length(e);
    return std::abs(sine) <= rounding ? sweep_diagonal(c) : sine > 0 ? 1 : 0;
}

/// Whether corners that are one in the shadow are one in space.
bool shadow_is_one_to_one(const std::vector<Vec3d>& points, const Face& face, const std::vector<Vec2d>& corners) {
    std::vector<std::size_t> order(face.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(corners[i].x, corners[i].y); });
    for (std::size_t k = 1; k < order.size(); ++k)
        if (corners[order[k]] == corners[order[k - 1]] && points[face[order[k]]] != points[face[order[k - 1]]])
            return false;
    return true;
}

/// Counter-clockwise triangles as positions in the face.
std::vector<std::array<std::uint32_t, 3>> cut(const std::vector<Vec3d>& points, const Face& face,
                                              const Shadow& shadow) {
    if (face.size() == 4) {
        const int diagonal = quad_diagonal(shadow.corners);
        if (diagonal == 0) return {{0, 1, 2}, {0, 2, 3}};
        if (diagonal == 1) return {{0, 1, 3}, {1, 2, 3}};
    }
    FilledProfile filled = fill({{shadow.corners}});
    const bool fits = filled.points.size() == face.size() && !filled.triangles.empty() &&
                      shadow_is_one_to_one(points, face, shadow.corners);
    if (fits) return std::move(filled.triangles);
    // Crossing sides, or no area: nothing fits; a fan leaves no hole.
    std::vector<std::array<std::uint32_t, 3>> fan;
    for (std::uint32_t i = 1; i + 1 < face.size(); ++i) fan.push_back({0, i, i + 1});
    return fan;
}

bool is_usable(const std::vector<Vec3d>& points, const Face& face) {
    return face.size() >= 3 &&
           std::ranges::all_of(face, [&](std::uint32_t i) { return i < points.size() && is_finite(points[i]); });
}

}  // namespace

TriangleMesh triangulate_polyhedron(const std::vector<Vec3d>& points, const std::vector<Face>& faces,
                                    MeshFaults& faults) {
    TriangleMesh mesh;
    mesh.vertices = points;
    for (const Face& written : faces) {
        if (!is_usable(points, written)) {
            ++faults.dropped_faces;
            continue;
        }
        const Face face(written.rbegin(), written.rend());
        if (face.size() == 3) {
            mesh.triangles.push_back({face[0], face[1], face[2]});
            continue;
        }
        const Shadow shadow = shadow_of(points, face);
        if (!is_planar(shadow)) ++faults.non_planar_faces;
        for (const auto& t : cut(points, face, shadow)) mesh.triangles.push_back({face[t[0]], face[t[1]], face[t[2]]});
    }
    return mesh;
}

}  // namespace cardioid::csg

#include "tests/models/mesh_distance.hpp"

#include <algorithm>
#include <limits>

namespace cardioid::test {
namespace {

/// Distance of p from the segment a b.
double to_segment(Vec3d p, Vec3d a, Vec3d b) {
    const Vec3d ab = b - a;
    const double squared = dot(ab, ab);
    const double s = squared > 0 ? std::clamp(dot(p - a, ab) / squared, 0.0, 1.0) : 0;
    return length(p - (a + ab * s));
}

double to_triangle(Vec3d p, Vec3d a, Vec3d b, Vec3d c) {
    const Vec3d n = cross(b - a, c - a);
    const double squared = dot(n, n);
    const bool over = squared > 0 && dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
                      dot(cross(a - c, p - c), n) >= 0;
    if (over) return std::abs(dot(p - a, n)) / std::sqrt(squared);
    return std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
}

/// Moeller and Trumbore 1997.
bool crosses(Vec3d o, Vec3d d, Vec3d a, Vec3d b, Vec3d c) {
    const Vec3d e = b - a, f = c - a, across = cross(d, f);
    const double det = dot(e, across);
    if (det == 0) return false;
    const Vec3d from_a = o - a;
    const double u = dot(from_a, across) / det;
    const Vec3d q = cross(from_a, e);
    const double v = dot(d, q) / det;
    return u >= 0 && v >= 0 && u + v < 1 && dot(f, q) / det > 0;
}

}  // namespace

bool inside_by_parity(const TriangleMesh& mesh, Vec3d p, Vec3d d) {
    bool inside = false;
    for (const auto& [i, j, k] : mesh.triangles)
        inside ^= crosses(p, d, mesh.vertices[i], mesh.vertices[j], mesh.vertices[k]);
    return inside;
}

double distance_to(const TriangleMesh& mesh, Vec3d p) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [i, j, k] : mesh.triangles)
        least = std::min(least, to_triangle(p, mesh.vertices[i], mesh.vertices[j], mesh.vertices[k]));
    return least;
}

}  // namespace cardioid::test

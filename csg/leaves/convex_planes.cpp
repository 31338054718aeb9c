#include "csg/leaves/convex_planes.hpp"

#include <algorithm>

namespace cardioid::csg {

namespace {

/// Corners of one face leave its plane by up to this share of the mesh's size, as numbers of six digits do.
constexpr double flat_share = 1e-6;

struct Face {
    Vec3d normal;  ///< of twice the triangle's area
    Vec3d corners[3];
};

/// Largest first: theirs are the surest planes.
std::vector<Face> faces_of(const TriangleMesh& mesh) {
    std::vector<Face> faces;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3d p = mesh.vertices[a], q = mesh.vertices[b], r = mesh.vertices[c];
        faces.push_back({cross(q - p, r - p), {p, q, r}});
    }
    std::stable_sort(faces.begin(), faces.end(),
                     [](const Face& x, const Face& y) { return dot(x.normal, x.normal) > dot(y.normal, y.normal); });
    return faces;
}

bool lies_in(const Face& face, const Plane& plane, double slack) {
    return dot(face.normal, plane.n) >= 0 &&
           std::all_of(std::begin(face.corners), std::end(face.corners),
                       [&](Vec3d p) { return std::abs(dot(plane.n, p) - plane.d) <= slack; });
}

bool encloses(const Plane& plane, const TriangleMesh& mesh, double slack) {
    return std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                       [&](Vec3d p) { return dot(plane.n, p) <= plane.d + slack; });
}

}  // namespace

std::vector<Plane> convex_planes(const TriangleMesh& mesh, std::size_t limit) {
    // Four triangles at a corner of three faces each: more than this cannot be merged into so few.
    if (!mesh.closed || mesh.triangles.empty() || mesh.triangles.size() > limit * limit) return {};
    Box3d box;
    for (const Vec3d& v : mesh.vertices) box.include(v);
    const double slack = flat_share * box.diagonal();
    std::vector<Plane> planes;
    for (const Face& face : faces_of(mesh)) {
        if (std::any_of(planes.begin(), planes.end(), [&](const Plane& p) { return lies_in(face, p, slack); }))
            continue;
        const double size = length(face.normal);
        // A sliver that lies in no plane of a neighbour has no direction of its own to be trusted.
        if (!(size > slack * box.diagonal()) || planes.size() == limit) return {};
        const Vec3d n = face.normal * (1 / size);
        const Plane plane{n, dot(n, face.corners[0])};
        if (!encloses(plane, mesh, slack)) return {};
        planes.push_back(plane);
    }
    return planes.size() >= 4 ? planes : std::vector<Plane>{};
}

}  // namespace cardioid::csg

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <CGAL/convex_decomposition_3.h>
#include <algorithm>

#include "csg/exact/hull.hpp"
#include "csg/exact/mesh_boolean.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::csg {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

[[noreturn]] void refuse(const char* why) {
    throw Error(ErrorCode::bad_input, std::string("a boolean of meshes failed: ") + why);
}

/// A Nef polyhedron fills all that its surface closes off from the outside, so cavities are cut out of it: shells from
/// the greatest to the least, that a part within a cavity is there again.
Nef of_shells(Polyhedron& polyhedron) {
    std::vector<Polyhedron> shells;
    pmp::split_connected_components(polyhedron, shells);
    std::vector<std::pair<Kernel::FT, std::size_t>> volumes;
    for (std::size_t i = 0; i < shells.size(); ++i) volumes.emplace_back(pmp::volume(shells[i]), i);
    if (std::ranges::all_of(volumes, [](const auto& v) { return v.first > 0; })) return Nef(polyhedron);
    std::ranges::sort(volumes, [](const auto& a, const auto& b) { return CGAL::abs(a.first) > CGAL::abs(b.first); });
    Nef out(Nef::EMPTY);
    for (const auto& [volume, i] : volumes) {
        const bool solid = volume > 0;
        if (!solid) pmp::reverse_face_orientations(shells[i]);
        const Nef shell(shells[i]);
        if (solid)
            out += shell;
        else
            out -= shell;
    }
    return out;
}

/// Triangles without area go: a Nef polyhedron has planes.
Nef to_nef(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) return Nef(Nef::EMPTY);
    std::vector<Kernel::Point_3> points;
    for (const Vec3d v : mesh.vertices) points.emplace_back(v.x, v.y, v.z);
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& [a, b, c] : mesh.triangles)
        if (!CGAL::collinear(points[a], points[b], points[c])) faces.push_back({a, b, c});
    pmp::orient_polygon_soup(points, faces);  // parts that touch in an edge or corner get corners of their own
    if (!pmp::is_polygon_soup_a_polygon_mesh(faces)) refuse("a surface is no manifold");
    Polyhedron polyhedron;
    pmp::polygon_soup_to_polygon_mesh(points, faces, polyhedron);
    if (!polyhedron.is_closed()) refuse("a mesh is not closed");
    return of_shells(polyhedron);
}

TriangleMesh to_mesh(const Nef& nef) {
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    CGAL::convert_nef_polyhedron_to_polygon_soup(nef, points, faces, true);
    TriangleMesh out;
    for (const auto& p : points)
        out.vertices.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    for (const auto& face : faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i)
            out.triangles.push_back({static_cast<std::uint32_t>(face[0]), static_cast<std::uint32_t>(face[i]),
                                     static_cast<std::uint32_t>(face[i + 1])});
    weld(out);
    return out;
}

Nef combine(SolidOp op, std::span<const TriangleMesh> parts) {
    Nef out = to_nef(parts[0]);
    for (const TriangleMesh& part : parts.subspan(1)) {
        const Nef next = to_nef(part);
        if (op == SolidOp::unite) out += next;
        if (op == SolidOp::intersect) out *= next;
        if (op == SolidOp::subtract) out -= next;
    }
    return out.regularization();
}

/// The corners of one shell of a volume.
class CornersOfShell {
public:
    void visit(Nef::Vertex_const_handle v) {
        const auto& p = v->point();
        corners.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    void visit(Nef::Halffacet_const_handle) {}
    void visit(Nef::SFace_const_handle) {}
    void visit(Nef::Halfedge_const_handle) {}
    void visit(Nef::SHalfedge_const_handle) {}
    void visit(Nef::SHalfloop_const_handle) {}
    std::vector<Vec3d> corners;
};

}  // namespace

TriangleMesh nef_boolean(SolidOp op, std::span<const TriangleMesh> parts) try {
    return parts.empty() ? TriangleMesh{} : to_mesh(combine(op, parts));
} catch (const CGAL::Failure_exception&) {
    refuse("a surface runs through itself or has an edge of too many faces");
}

std::vector<std::vector<Vec3d>> convex_parts(const TriangleMesh& mesh) try {
    if (is_convex(mesh)) return {mesh.vertices};
    Nef nef = to_nef(mesh);
    CGAL::convex_decomposition_3(nef);
    std::vector<std::vector<Vec3d>> out;
    for (auto volume = ++nef.volumes_begin(); volume != nef.volumes_end(); ++volume) {
        if (!volume->mark()) continue;
        CornersOfShell shell;
        nef.visit_shell_objects(Nef::SFace_const_handle(volume->shells_begin()), shell);
        out.push_back(std::move(shell.corners));
    }
    return out;
} catch (const CGAL::Failure_exception&) {
    refuse("a surface runs through itself or has an edge of too many faces");
}

}  // namespace cardioid::csg

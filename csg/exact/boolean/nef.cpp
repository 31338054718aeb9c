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

#include "csg/exact/boolean/exact_data.hpp"
#include "csg/exact/boolean/mesh_boolean.hpp"
#include "csg/exact/hull.hpp"
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

Kernel::FT volume_of(const Nef& nef) {
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    CGAL::convert_nef_polyhedron_to_polygon_soup(nef, points, faces, true);
    Kernel::FT sum = 0;
    for (const auto& face : faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i)
            sum += CGAL::volume(Kernel::Point_3(CGAL::ORIGIN), points[face[0]], points[face[i]], points[face[i + 1]]);
    return sum;
}

/// A shell of a polyhedron, and what it encloses: negative for a cavity.
struct Shell {
    Polyhedron surface;
    Kernel::FT volume;
};

std::vector<Shell> shells_of(Polyhedron& polyhedron) {
    std::vector<Polyhedron> surfaces;
    pmp::split_connected_components(polyhedron, surfaces);
    std::vector<Shell> out;
    for (Polyhedron& surface : surfaces) {
        const Kernel::FT volume = pmp::volume(surface);
        out.push_back({std::move(surface), volume});
    }
    return out;
}

/// Shells from the greatest to the least, cavities cut out, so that a part within a cavity is there again.
Nef one_by_one(std::vector<Shell> shells) {
    std::ranges::sort(shells, [](const Shell& a, const Shell& b) { return CGAL::abs(a.volume) > CGAL::abs(b.volume); });
    Nef out(Nef::EMPTY);
    for (Shell& shell : shells) {
        const bool solid = shell.volume > 0;
        if (!solid) pmp::reverse_face_orientations(shell.surface);
        const Nef nef(shell.surface);
        if (solid)
            out += nef;
        else
            out -= nef;
    }
    return out;
}

/// A Nef polyhedron fills all that its surface closes off from the outside, so cavities are cut out of it. Shells that
/// touch are united; where CGAL cannot, which slivers bring about, it is given them at once, and has to have
/// understood.
Nef of_shells(Polyhedron& polyhedron, bool may_touch) {
    std::vector<Shell> shells = shells_of(polyhedron);
    const bool has_cavity = std::ranges::any_of(shells, [](const Shell& s) { return s.volume <= 0; });
    if (!may_touch && !has_cavity) return Nef(polyhedron);
    Kernel::FT sum = 0;
    for (const Shell& shell : shells) sum += shell.volume;
    try {
        return one_by_one(std::move(shells));
    } catch (const CGAL::Failure_exception&) {
        if (has_cavity) throw;
        Nef whole(polyhedron);
        if (volume_of(whole) != sum) throw;
        return whole;
    }
}

class KeptNef : public NefHolder {
public:
    explicit KeptNef(Nef of) : nef(std::move(of)) {}
    Nef nef;
};

/// Triangles without area go: a Nef polyhedron has planes.
Nef to_nef(const ExactSolid& solid) {
    if (solid.empty()) return Nef(Nef::EMPTY);
    if (const auto* kept = dynamic_cast<const KeptNef*>(solid.data().nef.get())) return kept->nef;
    std::vector<Kernel::Point_3> points = solid.data().points;
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& [a, b, c] : solid.data().triangles)
        if (!CGAL::collinear(points[a], points[b], points[c])) faces.push_back({a, b, c});
    const bool manifold = pmp::is_polygon_soup_a_polygon_mesh(faces);
    // Parts that touch in an edge or corner get corners of their own.
    if (!manifold) pmp::orient_polygon_soup(points, faces);
    if (!manifold && !pmp::is_polygon_soup_a_polygon_mesh(faces)) refuse("a surface is no manifold");
    Polyhedron polyhedron;
    pmp::polygon_soup_to_polygon_mesh(points, faces, polyhedron);
    if (!polyhedron.is_closed()) refuse("a mesh is not closed");
    return of_shells(polyhedron, !manifold || !(solid.data().sound || solid.data().plain));
}

ExactSolid to_solid(Nef nef) {
    if (nef.is_empty()) return {};
    auto out = std::make_shared<ExactData>();
    std::vector<std::vector<std::size_t>> faces;
    CGAL::convert_nef_polyhedron_to_polygon_soup(nef, out->points, faces, true);
    for (const auto& face : faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i)
            out->triangles.push_back({static_cast<std::uint32_t>(face[0]), static_cast<std::uint32_t>(face[i]),
                                      static_cast<std::uint32_t>(face[i + 1])});
    out->settle();
    out->nef = std::make_shared<KeptNef>(std::move(nef));
    return ExactSolid(std::move(out));
}

Nef combine(SolidOp op, std::span<const ExactSolid> parts) {
    Nef out = to_nef(parts[0]);
    for (const ExactSolid& part : parts.subspan(1)) {
        Interruption::check();
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

ExactSolid nef_boolean(SolidOp op, std::span<const ExactSolid> parts) try {
    return parts.empty() ? ExactSolid{} : to_solid(combine(op, parts));
} catch (const CGAL::Failure_exception&) {
    refuse("a surface runs through itself or has an edge of too many faces");
}

std::vector<std::vector<Vec3d>> convex_parts(const TriangleMesh& mesh) try {
    if (is_convex(mesh)) return {mesh.vertices};
    Nef nef = to_nef(ExactSolid(mesh));
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

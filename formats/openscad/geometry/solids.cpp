#include "formats/openscad/geometry/solids.hpp"

#include <algorithm>
#include <cmath>

#include "csg/shapes/mesh_repair.hpp"
#include "formats/mesh/mesh_file.hpp"
#include "formats/openscad/geometry/plane_files.hpp"
#include "formats/openscad/geometry/surface.hpp"
#include "formats/openscad/geometry/transforms.hpp"
#include "formats/openscad/prune.hpp"

namespace cardioid::formats::openscad {
namespace {

/// A removed solid: OpenSCAD makes nothing of sizes that are not finite or enclose nothing.
std::optional<Shape> removed(const Arguments& args, ShapeContext& context, const char* why) {
    context.warnings.add(args.where(), std::string(why) + ": removed");
    return std::nullopt;
}

bool positive(double x) { return x > 0 && std::isfinite(x); }

/// d / 2 where d is given, else r.
std::optional<double> radius(const Arguments& args, const char* d, const char* r) {
    if (const auto diameter = args.number(d)) return *diameter / 2;
    return args.number(r);
}

std::optional<Shape> cube(const Arguments& args, ShapeContext& context) {
    const Vec3d size = args.size("size", 1);
    if (!positive(size.x) || !positive(size.y) || !positive(size.z))
        return removed(args, context, "cube() has a size that is not above 0 and finite");
    Shape out{LeafKind::box, Affine::scaling(size)};
    if (args.boolean("center", false)) out.local.t = size * -0.5;
    return out;
}

std::optional<Shape> sphere(const Arguments& args, ShapeContext& context) {
    const double r = radius(args, "d", "r").value_or(1);
    if (!positive(r)) return removed(args, context, "sphere() has a radius that is not above 0 and finite");
    const csg::FacetSettings facets = facet_settings(args);
    Shape out{LeafKind::sphere, Affine::scaling({r, r, r})};
    if (is_curved(facets, context.options)) return out;
    const int n = csg::facet_count(r, facets);
    const auto [at, fresh] = context.balls.try_emplace(n, 0);
    if (fresh) {
        TriangleMesh mesh = csg::faceted_sphere(1, n);
        csg::repair(mesh);
        renumber(mesh);
        at->second = context.solids.add_mesh(std::move(mesh));
    }
    out.kind = LeafKind::mesh;
    out.data = at->second;
    return out;
}

/// A cone to a point, or a frustum of very many facets, of n facets: unit meshes are shared where they can be.
Shape faceted_cone(double h, double r1, double r2, int n, ShapeContext& context) {
    if (r1 > 0 && r2 > 0 && static_cast<std::size_t>(n) <= most_profile_edges) {
        const auto [at, fresh] = context.discs.try_emplace(n, 0);
        if (fresh) at->second = context.solids.add_profile({{csg::circle_points(1, n)}});
        return {LeafKind::prism, Affine::scaling({r1, r1, h}), r2 / r1, 0, at->second};
    }
    if (r1 > 0 && r2 > 0) {
        TriangleMesh mesh = csg::faceted_cone(1, 1, r2 / r1, n);
        csg::repair(mesh);
        renumber(mesh);
        return {LeafKind::mesh, Affine::scaling({r1, r1, h}), 0, 0, context.solids.add_mesh(std::move(mesh))};
    }
    const auto [at, fresh] = context.cones.try_emplace(n, 0);
    if (fresh) {
        TriangleMesh mesh = csg::faceted_cone(1, 1, 0, n);
        csg::repair(mesh);
        renumber(mesh);
        at->second = context.solids.add_mesh(std::move(mesh));
    }
    const double r = std::max(r1, r2);
    Affine local = Affine::scaling({r, r, h});
    if (r1 == 0) local = Affine::translation({0, 0, h}) * Affine::scaling({r, r, -h});  // it stands on its point
    return {LeafKind::mesh, local, 0, 0, at->second};
}

std::optional<Shape> cylinder(const Arguments& args, ShapeContext& context) {
    const double h = args.number("h", 1);
    const std::optional<double> r = radius(args, "d", "r");
    const double r1 = radius(args, "d1", "r1").value_or(r.value_or(1));
    const double r2 = radius(args, "d2", "r2").value_or(r.value_or(1));
    const bool radii = r1 >= 0 && r2 >= 0 && std::isfinite(r1) && std::isfinite(r2) && (r1 > 0 || r2 > 0);
    if (!positive(h) || !radii)
        return removed(args, context, "cylinder() has a height or radii that are not above 0 and finite");
    const csg::FacetSettings facets = facet_settings(args);
    Shape out{LeafKind::cone, Affine::scaling({1, 1, h}), r1, r2};
    if (!is_curved(facets, context.options))
        out = faceted_cone(h, r1, r2, csg::facet_count(std::max(r1, r2), facets), context);
    if (args.boolean("center", false)) out.local = Affine::translation({0, 0, h / -2}) * out.local;
    return out;
}

std::optional<Shape> torus(const Arguments& args, ShapeContext& context) {
    const auto ring = args.number("R"), tube = args.number("r");
    if (!ring || !tube) args.fail("torus() wants the radius of the ring and of the tube: torus(R = 10, r = 2)");
    if (!positive(*tube) || !std::isfinite(*ring))
        return removed(args, context, "torus() has a radius that is not above 0 and finite");
    if (*tube >= *ring) args.fail("torus() has a tube as thick as its ring or thicker, wanted r < R");
    return Shape{LeafKind::torus, {}, *ring, *tube};
}

std::optional<Shape> ellipsoid(const Arguments& args, ShapeContext& context) {
    if (!args.has("radii")) args.fail("ellipsoid() wants its three radii: ellipsoid([a, b, c])");
    const auto r = *args.numbers("radii", 3);
    if (!positive(r[0]) || !positive(r[1]) || !positive(r[2]))
        return removed(args, context, "ellipsoid() has a radius that is not above 0 and finite");
    return Shape{LeafKind::sphere, Affine::scaling({r[0], r[1], r[2]})};
}

/// n . x <= d; n need not have length 1.
std::optional<Shape> half_space(const Arguments& args, ShapeContext& context) {
    const auto xs = args.numbers("n", 3);
    if (!xs) args.fail("half_space() wants the outward normal and the offset: half_space([0, 0, 1], 0)");
    const Vec3d n{(*xs)[0], (*xs)[1], (*xs)[2]};
    const double d = args.number("d", 0), size = length(n);
    if (!positive(size) || !std::isfinite(d))
        return removed(args, context, "half_space() has a normal of no length or numbers that are not finite");
    Affine local = rotation_to(n);
    local.t = local.column(2) * (d / size);
    return Shape{LeafKind::half_space, local};
}

/// import() and include_mesh(); a file that is not there is an error of the latter, which OpenSCAD does not have.
std::optional<Shape> mesh_file(Node node, const Arguments& args, ShapeContext& context) {
    const std::string name = args.text(args.has("file") ? "file" : "filename");
    if (name.empty()) return removed(args, context, "found no file name, wanted import(file = \"model.stl\")");
    const std::string type = lower_extension(name);
    static constexpr std::string_view known[] = {".stl", ".obj",  ".ply", ".off", ".amf",
                                                 ".3mf", ".gltf", ".glb", ".nef3"};
    if (std::ranges::find(known, type) == std::end(known))
        args.fail("found \"" + name + "\", can import STL, OBJ, PLY, OFF, AMF, 3MF, NEF3, glTF, DXF and SVG");
    const std::string path = path_of(name, context);
    if (const auto at = context.mesh_files.find(path); at != context.mesh_files.end())
        return Shape{LeafKind::mesh, {}, 0, 0, at->second};
    TriangleMesh mesh;
    try {
        mesh = read_mesh(path);
    } catch (const Error& e) {
        if (node == Node::include_mesh) throw Error(e.code(), args.where() + ": " + e.what());
        pass_over(e, args, context);
        return std::nullopt;
    }
    auto out = make_mesh(std::move(mesh), args.where(), context);
    if (out) context.mesh_files.emplace(path, out->data);
    return out;
}

}  // namespace

csg::FacetSettings facet_settings(const Arguments& args) {
    csg::FacetSettings out;
    out.fn = args.number("$fn", out.fn);
    out.fa = args.number("$fa", out.fa);
    out.fs = args.number("$fs", out.fs);
    return out;
}

bool is_curved(const csg::FacetSettings& facets, const ReadOptions& options) {
    if (options.openscad_facets || std::isnan(facets.fn) || std::isinf(facets.fn)) return false;
    return facets.fn <= 0 || facets.fn >= options.smooth_from;
}

std::size_t edge_count(const Profile& profile) {
    std::size_t n = 0;
    for (const auto& contour : profile.contours) n += contour.size();
    return n;
}

std::optional<Shape> make_mesh(TriangleMesh mesh, const std::string& where, ShapeContext& context) {
    const csg::MeshFaults faults = csg::repair(mesh);
    if (mesh.triangles.empty()) {
        context.warnings.add(where, "a mesh without triangles: removed");
        return std::nullopt;
    }
    if (!faults.closed())
        context.warnings.add(where, "the mesh is not closed: " + std::to_string(faults.open_edges) + " open edges, " +
                                        std::to_string(faults.crowded_edges) + " edges of too many triangles");
    renumber(mesh);
    return Shape{LeafKind::mesh, {}, 0, 0, context.solids.add_mesh(std::move(mesh))};
}

std::optional<Shape> make_solid(Node node, const Arguments& args, ShapeContext& context) {
    switch (node) {
        case Node::cube:
            return cube(args, context);
        case Node::sphere:
            return sphere(args, context);
        case Node::cylinder:
            return cylinder(args, context);
        case Node::polyhedron:
            return make_polyhedron(args, context);
        case Node::torus:
            return torus(args, context);
        case Node::ellipsoid:
            return ellipsoid(args, context);
        case Node::half_space:
            return half_space(args, context);
        case Node::import_file:
        case Node::include_mesh:
            return mesh_file(node, args, context);
        case Node::surface:
            return make_surface(args, context);
        default:
            return std::nullopt;
    }
}

}  // namespace cardioid::formats::openscad

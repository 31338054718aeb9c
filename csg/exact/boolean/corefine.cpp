#include "csg/exact/boolean/corefine.hpp"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <algorithm>
#include <limits>

#include "csg/exact/boolean/cgal_corefinement.hpp"
#include "csg/exact/boolean/exact_data.hpp"

namespace cardioid::csg {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = ExactKernel;
using Mesh = CountedMesh;

/// Far more steps than any corefinement has been seen to take: for each, and for each triangle.
constexpr std::int64_t most_steps = 10'000'000, most_steps_a_triangle = 10'000;

/// A part as CGAL wants it: every edge of two triangles, no triangle without area. False where it cannot be had.
bool to_surface(const ExactData& data, Mesh& out) {
    const auto is_flat = [&](const std::array<std::uint32_t, 3>& t) {
        return CGAL::collinear(data.points[t[0]], data.points[t[1]], data.points[t[2]]);
    };
    if (!data.sound && std::ranges::any_of(data.triangles, is_flat)) return false;
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& [a, b, c] : data.triangles) faces.push_back({a, b, c});
    if (!pmp::is_polygon_soup_a_polygon_mesh(faces)) return false;
    pmp::polygon_soup_to_polygon_mesh(data.points, faces, out);
    if (data.sound) return true;
    return CGAL::is_closed(out) && !pmp::does_self_intersect(out) && pmp::does_bound_a_volume(out);
}

ExactSolid to_solid(const Mesh& mesh) {
    if (mesh.number_of_faces() == 0) return {};
    auto out = std::make_shared<ExactData>();
    std::vector<std::uint32_t> number(mesh.num_vertices());
    for (const auto v : mesh.vertices()) {
        number[v.idx()] = static_cast<std::uint32_t>(out->points.size());
        out->points.push_back(mesh.point(v));
    }
    for (const auto f : mesh.faces()) {
        std::array<std::uint32_t, 3> triangle{};
        std::size_t i = 0;
        for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
            if (i < 3) triangle[i++] = number[v.idx()];
        out->triangles.push_back(triangle);
    }
    out->sound = out->settle();
    return ExactSolid(std::move(out));
}

bool apply(SolidOp op, Mesh& a, Mesh& b, Mesh& out) {
    if (!CGAL::do_overlap(pmp::bbox(a), pmp::bbox(b))) {  // nothing in common
        if (op != SolidOp::intersect) out = a;
        if (op == SolidOp::unite) out += b;
        return true;
    }
    const auto triangles = static_cast<std::int64_t>(a.number_of_faces() + b.number_of_faces());
    steps_left = most_steps + most_steps_a_triangle * triangles;
    const auto quiet = CGAL::parameters::throw_on_self_intersection(true);
    if (op == SolidOp::unite) return pmp::corefine_and_compute_union(a, b, out, quiet);
    if (op == SolidOp::intersect) return pmp::corefine_and_compute_intersection(a, b, out, quiet);
    return pmp::corefine_and_compute_difference(a, b, out, quiet);
}

/// Unites the smallest first, so that each triangle takes part in few unions.
bool unite_all(std::vector<Mesh> parts, Mesh& out) {
    const auto larger = [](const Mesh& a, const Mesh& b) { return a.number_of_faces() > b.number_of_faces(); };
    std::ranges::make_heap(parts, larger);
    const auto pop = [&] {
        std::ranges::pop_heap(parts, larger);
        Mesh mesh = std::move(parts.back());
        parts.pop_back();
        return mesh;
    };
    while (parts.size() > 1) {
        Interruption::check();
        Mesh a = pop(), b = pop(), both;
        if (!apply(SolidOp::unite, a, b, both)) return false;
        both.collect_garbage();
        parts.push_back(std::move(both));
        std::ranges::push_heap(parts, larger);
    }
    if (!parts.empty()) out = std::move(parts[0]);
    return true;
}

bool intersect_all(std::vector<Mesh>& parts, Mesh& out) {
    out = std::move(parts[0]);
    for (std::size_t i = 1; i < parts.size() && out.number_of_faces() > 0; ++i) {
        Interruption::check();
        Mesh common;
        if (!apply(SolidOp::intersect, out, parts[i], common)) return false;
        common.collect_garbage();
        out = std::move(common);
    }
    return true;
}

bool combine(SolidOp op, std::vector<Mesh> parts, Mesh& out) {
    if (op == SolidOp::unite) return unite_all(std::move(parts), out);
    if (op == SolidOp::intersect) return intersect_all(parts, out);
    Mesh first = std::move(parts[0]), rest;
    parts.erase(parts.begin());
    if (!unite_all(std::move(parts), rest)) return false;
    if (rest.number_of_faces() == 0) {
        out = std::move(first);
        return true;
    }
    return apply(SolidOp::subtract, first, rest, out);
}

}  // namespace

std::optional<ExactSolid> corefine(SolidOp op, std::span<const ExactSolid> parts) try {
    steps_left = std::numeric_limits<std::int64_t>::max();
    std::vector<Mesh> exact(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!to_surface(parts[i].data(), exact[i])) return std::nullopt;
    Mesh result;
    if (exact.empty() || !combine(op, std::move(exact), result)) return std::nullopt;
    steps_left = std::numeric_limits<std::int64_t>::max();
    result.collect_garbage();
    return to_solid(result);
} catch (const Error&) {  // interrupted
    throw;
} catch (const std::exception&) {  // a surface that runs through itself; CGAL's own checks
    return std::nullopt;
}

}  // namespace cardioid::csg

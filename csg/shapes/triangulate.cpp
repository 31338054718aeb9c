#include "csg/shapes/triangulate.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <algorithm>
#include <cmath>

#include "csg/shapes/mesh_repair.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::csg {

namespace {

constexpr std::uint32_t unnumbered = 0xFFFFFFFFU;

/// What a triangle of the plane knows: whether the flood has been here, and whether it is inside.
struct FaceMark {
    bool seen = false, inside = false;
};
/// A vertex's number; CGAL makes further vertices where contours cross.
struct VertexNumber {
    std::uint32_t value = unnumbered;
};

template <class Base>
struct MarkedFace : Base {
    using Base::Base;
    template <class Tds>
    struct Rebind_TDS {
        using Other = MarkedFace<typename Base::template Rebind_TDS<Tds>::Other>;
    };
    FaceMark mark;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexNumber, Kernel>;
using FaceBase = MarkedFace<CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;
using Triangulation = CGAL::Constrained_triangulation_plus_2<Delaunay>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

/// Spreads the low 32 bits to the even bits of 64.
std::uint64_t spread(std::uint64_t x) {
    x = (x | x << 16) & 0x0000FFFF0000FFFFULL;
    x = (x | x << 8) & 0x00FF00FF00FF00FFULL;
    x = (x | x << 4) & 0x0F0F0F0F0F0F0F0FULL;
    x = (x | x << 2) & 0x3333333333333333ULL;
    return (x | x << 1) & 0x5555555555555555ULL;
}

/// Indices of the points along a Morton curve: neighbours in turn make few flips, where points in the order of their
/// contour need quadratically many.
std::vector<std::uint32_t> along_curve(const std::vector<Vec2d>& points) {
    Vec2d lo = points[0], hi = points[0];
    for (const Vec2d p : points) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
    }
    const double size = std::max(hi.x - lo.x, hi.y - lo.y);
    const double scale = size > 0 && std::isfinite(size) ? 0xFFFFFFFFU / size : 0;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed;
    keyed.reserve(points.size());
    for (const Vec2d p : points) {
        const auto x = static_cast<std::uint32_t>((p.x - lo.x) * scale);
        const auto y = static_cast<std::uint32_t>((p.y - lo.y) * scale);
        keyed.emplace_back(spread(x) | spread(y) << 1, static_cast<std::uint32_t>(keyed.size()));
    }
    std::ranges::sort(keyed);
    std::vector<std::uint32_t> out;
    out.reserve(points.size());
    for (const auto& key : keyed) out.push_back(key.second);
    return out;
}

std::vector<Vertex> insert_points(Triangulation& net, const std::vector<Vec2d>& points) {
    std::vector<Vertex> out(points.size());
    Face hint;
    for (const std::uint32_t i : along_curve(points)) {
        out[i] = net.insert({points[i].x, points[i].y}, hint);
        std::uint32_t& value = out[i]->info().value;
        value = std::min(value, i);  // `unnumbered` is the largest; equal points keep the first one's number
        hint = out[i]->face();
    }
    return out;
}

/// Numbers a vertex that CGAL made, and keeps its place.
std::uint32_t number(Vertex v, std::vector<Vec2d>& points) {
    if (v->info().value == unnumbered) {
        v->info().value = static_cast<std::uint32_t>(points.size());
        points.push_back({v->point().x(), v->point().y()});
    }
    return v->info().value;
}

/// Whether the even-odd rule changes sides at edge i of a face: edges run an even number of times are none.
bool is_border(const Triangulation& net, Face face, int i) {
    if (!face->is_constrained(i)) return false;
    return net.number_of_enclosing_constraints(face->vertex(Triangulation::cw(i)),
                                               face->vertex(Triangulation::ccw(i))) &
           1;
}

void mark_inside(const Triangulation& net) {
    std::vector<Face> stack{net.infinite_face()};
    stack[0]->mark = {true, false};
    while (!stack.empty()) {
        const Face face = stack.back();
        stack.pop_back();
        for (int i = 0; i < 3; ++i) {
            const Face other = face->neighbor(i);
            if (other->mark.seen) continue;
            other->mark = {true, face->mark.inside != is_border(net, face, i)};
            stack.push_back(other);
        }
    }
}

}  // namespace

FilledProfile fill(const Profile& profile) {
    FilledProfile out;
    for (const auto& contour : profile.contours) out.points.insert(out.points.end(), contour.begin(), contour.end());
    if (out.points.empty()) return out;
    Triangulation net;
    const std::vector<Vertex> vertices = insert_points(net, out.points);
    std::vector<std::vector<Triangulation::Constraint_id>> edges;
    std::size_t first = 0;
    for (const auto& contour : profile.contours) {
        auto& of_contour = edges.emplace_back();
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const Vertex a = vertices[first + i], b = vertices[first + (i + 1) % contour.size()];
            if (a != b) of_contour.push_back(net.insert_constraint(a, b));
        }
        first += contour.size();
    }
    for (const auto& contour : edges) {
        auto& indices = out.contours.emplace_back();
        for (const auto& edge : contour)  // the last vertex of an edge is the first of the next
            for (auto v = net.vertices_in_constraint_begin(edge); std::next(v) != net.vertices_in_constraint_end(edge);
                 ++v)
                indices.push_back(number(*v, out.points));
    }
    if (net.dimension() < 2) return out;
    mark_inside(net);
    for (const Face face : net.finite_face_handles())
        if (face->mark.inside)
            out.triangles.push_back(
                {face->vertex(0)->info().value, face->vertex(1)->info().value, face->vertex(2)->info().value});
    return out;
}

std::vector<std::array<std::uint32_t, 3>> triangulate(const Profile& profile) {
    FilledProfile filled = fill(profile);
    std::size_t given = 0;
    for (const auto& contour : profile.contours) given += contour.size();
    if (filled.points.size() > given) throw Error(ErrorCode::bad_input, "the contours of a plane figure cross");
    return std::move(filled.triangles);
}

}  // namespace cardioid::csg

#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "rt_core/scene/triangle_mesh.hpp"

namespace cardioid::csg {

/// A triangle's side as its edge sees it.
struct HalfEdge {
    std::uint32_t to;        ///< the edge's greater vertex
    std::uint32_t forward;   ///< 1 where the triangle runs from the lesser to the greater vertex, else 0
    std::uint32_t triangle;  ///< whose side it is
};

/// Half-edges sorted into one run per lesser vertex.
struct HalfEdges {
    std::vector<std::size_t> first;  ///< per vertex; one more at the end
    std::vector<HalfEdge> sides;     ///< within a vertex by `to`, then by triangle
};
HalfEdges half_edges(const TriangleMesh& mesh);

/// Calls visit(a, b, sides) for every edge a < b with all triangle sides on it, in order; O(n).
template <class Visit>
void for_each_edge(const TriangleMesh& mesh, Visit&& visit) {
    const HalfEdges edges = half_edges(mesh);
    for (std::uint32_t a = 0; a < mesh.vertices.size(); ++a)
        for (std::size_t i = edges.first[a], end = i; i < edges.first[a + 1]; i = end) {
            while (end < edges.first[a + 1] && edges.sides[end].to == edges.sides[i].to) ++end;
            visit(a, edges.sides[i].to, std::span(edges.sides).subspan(i, end - i));
        }
}

/// Triangles to turn so that neighbours over edges with two triangles agree: per connected part the lesser number.
std::vector<std::uint32_t> misturned_triangles(const TriangleMesh& mesh);

}  // namespace cardioid::csg

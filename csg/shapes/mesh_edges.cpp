#include "csg/shapes/mesh_edges.hpp"

namespace cardioid::csg {

HalfEdges half_edges(const TriangleMesh& mesh) {
    HalfEdges out;
    out.first.assign(mesh.vertices.size() + 1, 0);
    const auto for_each_side = [&](auto&& visit) {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
                visit(std::min(a, b), HalfEdge{std::max(a, b), a < b ? 1U : 0U, t});
            }
    };
    for_each_side([&](std::uint32_t from, const HalfEdge&) { ++out.first[from + 1]; });
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) out.first[v + 1] += out.first[v];
    out.sides.resize(3 * mesh.triangles.size());
    std::vector<std::size_t> next(out.first.begin(), out.first.end() - 1);
    for_each_side([&](std::uint32_t from, const HalfEdge& side) { out.sides[next[from]++] = side; });
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        std::sort(
            out.sides.begin() + static_cast<std::ptrdiff_t>(out.first[v]),
            out.sides.begin() + static_cast<std::ptrdiff_t>(out.first[v + 1]),
            [](const HalfEdge& a, const HalfEdge& b) { return a.to != b.to ? a.to < b.to : a.triangle < b.triangle; });
    return out;
}

namespace {

/// Which triangle lies over an edge, and whether it runs the edge against the first, as neighbours should.
struct Neighbour {
    std::uint32_t triangle;
    bool agrees;
};

/// The up to three neighbours of each triangle, over edges with exactly two sides.
std::vector<std::vector<Neighbour>> neighbours(const TriangleMesh& mesh) {
    std::vector<std::vector<Neighbour>> out(mesh.triangles.size());
    for_each_edge(mesh, [&](std::uint32_t, std::uint32_t, std::span<const HalfEdge> sides) {
        if (sides.size() != 2) return;
        const bool agrees = sides[0].forward != sides[1].forward;
        out[sides[0].triangle].push_back({sides[1].triangle, agrees});
        out[sides[1].triangle].push_back({sides[0].triangle, agrees});
    });
    return out;
}

}  // namespace

std::vector<std::uint32_t> misturned_triangles(const TriangleMesh& mesh) {
    const auto adjacent = neighbours(mesh);
    enum class Sense : std::uint8_t { unknown, kept, turned };
    std::vector<Sense> sense(mesh.triangles.size(), Sense::unknown);
    std::vector<std::uint32_t> out, part;
    for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
        if (sense[seed] != Sense::unknown) continue;
        part.assign(1, seed);
        sense[seed] = Sense::kept;
        for (std::size_t i = 0; i < part.size(); ++i)
            for (const Neighbour& n : adjacent[part[i]]) {
                if (sense[n.triangle] != Sense::unknown) continue;
                const bool kept = (sense[part[i]] == Sense::kept) == n.agrees;
                sense[n.triangle] = kept ? Sense::kept : Sense::turned;
                part.push_back(n.triangle);
            }
        const auto turned = std::ranges::count_if(part, [&](std::uint32_t t) { return sense[t] == Sense::turned; });
        const bool most_are_turned = 2 * turned > std::ssize(part);
        const Sense wrong = most_are_turned ? Sense::kept : Sense::turned;
        for (const std::uint32_t t : part)
            if (sense[t] == wrong) out.push_back(t);
    }
    return out;
}

}  // namespace cardioid::csg

#include "csg/shapes/side_edges.hpp"

#include <algorithm>
#include <limits>

#include "rt_core/api/error.hpp"

namespace cardioid::csg {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Triangle sides that no other triangle runs the other way, sorted.
std::vector<Edge> border(const FilledProfile& filled) {
    std::vector<Edge> all, out;
    all.reserve(3 * filled.triangles.size());
    for (const auto& t : filled.triangles)
        for (std::size_t i = 0; i < 3; ++i) all.emplace_back(t[i], t[(i + 1) % 3]);
    std::ranges::sort(all);
    std::ranges::copy_if(all, std::back_inserter(out), [&](const Edge& edge) {
        return !std::ranges::binary_search(all, Edge{edge.second, edge.first});
    });
    return out;
}

double twice_area(const FilledProfile& filled, const std::vector<std::uint32_t>& contour) {
    double out = 0;
    const Vec2d from = filled.points[contour[0]];
    for (std::size_t i = 1; i + 1 < contour.size(); ++i)
        out += cross(filled.points[contour[i]] - from, filled.points[contour[i + 1]] - from);
    return out;
}

}  // namespace

std::vector<SideEdge> side_edges(const FilledProfile& filled) {
    const std::vector<Edge> edges = border(filled);
    std::vector<bool> used(edges.size(), false);
    const auto take = [&](const Edge& edge) {
        const auto at = std::ranges::lower_bound(edges, edge);
        if (at == edges.end() || *at != edge || used[static_cast<std::size_t>(at - edges.begin())]) return false;
        used[static_cast<std::size_t>(at - edges.begin())] = true;
        return true;
    };
    std::vector<SideEdge> out;
    out.reserve(edges.size());
    for (const auto& contour : filled.contours) {
        if (contour.empty()) continue;
        const bool left_turning = twice_area(filled, contour) > 0;
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const std::uint32_t a = contour[i], b = contour[(i + 1) % contour.size()];
            if (take({a, b})) out.push_back({a, b, left_turning});
            if (take({b, a})) out.push_back({b, a, !left_turning});
        }
    }
    return out;
}

void append_cap(TriangleMesh& mesh, const FilledProfile& filled, std::size_t first, bool as_filled) {
    const auto at = static_cast<std::uint32_t>(first);
    for (const auto& [a, b, c] : filled.triangles)
        mesh.triangles.push_back({at + a, at + (as_filled ? b : c), at + (as_filled ? c : b)});
}

void check_corner_count(double corners) {
    if (!(corners < std::numeric_limits<std::uint32_t>::max()))
        throw Error(ErrorCode::limit, "a solid with more than 2^32 corners: fewer slices or facets are needed");
}

}  // namespace cardioid::csg

#include "csg/exact/section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "csg/exact/evaluate_mesh.hpp"
#include "csg/exact/walk.hpp"
#include "csg/shapes/clipper_paths.hpp"
#include "csg/shapes/profile_boolean.hpp"
#include "csg/shapes/profile_offset.hpp"

namespace cardioid::csg {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using Loops = std::vector<std::vector<Vec2d>>;

/// Joins directed links from key to key into closed loops of the keys' points; what does not close is left out.
template <class Key, class PointOf>
Loops join(std::multimap<Key, Key>& links, PointOf&& point_of) {
    Loops out;
    while (!links.empty()) {
        const Key start = links.begin()->first;
        std::vector<Vec2d> loop;
        Key at = start;
        for (auto next = links.begin(); next != links.end(); next = links.find(at)) {
            loop.push_back(point_of(at));
            at = next->second;
            links.erase(next);
            if (at == start) break;
        }
        if (at == start && loop.size() >= 3) out.push_back(std::move(loop));
    }
    return out;
}

/// The contours of a mesh a hair above (or below) z = 0: corners at 0 count as below it (or above).
Profile contours(const TriangleMesh& mesh, bool hair_above) {
    const auto is_above = [&](std::uint32_t v) {
        const double z = mesh.vertices[v].z;
        return hair_above ? z > 0 : z >= 0;
    };
    std::multimap<Edge, Edge> links;
    for (const auto& t : mesh.triangles) {
        Edge up, down;
        int crossings = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            if (is_above(a) == is_above(b)) continue;
            (is_above(b) ? up : down) = Edge(std::min(a, b), std::max(a, b));
            ++crossings;
        }
        if (crossings == 2) links.emplace(up, down);
    }
    const auto point_of = [&](const Edge& edge) {
        const Vec3d a = mesh.vertices[edge.first], b = mesh.vertices[edge.second];
        if (a.z == b.z) return Vec2d{a.x, a.y};
        const double t = a.z / (a.z - b.z);
        return Vec2d{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    };
    return {join(links, point_of)};
}

Profile section_beside(const SolidTree& tree, std::uint32_t node, double tolerance, double grid, bool hair_above) {
    std::map<std::uint32_t, Profile> done;
    for (const std::uint32_t index : nodes_below(tree, node)) {
        const SolidNode& at = tree.nodes[index];
        if (at.op == SolidOp::leaf) {
            const Profile cut = contours(evaluate_leaf(tree, index, node, tolerance), hair_above);
            done.emplace(index, profile_boolean(ProfileOp::unite, std::array{cut}, grid));
            continue;
        }
        std::vector<Profile> parts;
        for (std::uint32_t c = 0; c < at.count; ++c) parts.push_back(std::move(done[tree.children[at.first + c]]));
        const ProfileOp op = at.op == SolidOp::unite       ? ProfileOp::unite
                             : at.op == SolidOp::intersect ? ProfileOp::intersect
                                                           : ProfileOp::subtract;
        done.emplace(index, profile_boolean(op, parts, grid));
    }
    return std::move(done[node]);
}

/// Without contours thinner than the grid: what snapping two edges that almost coincide leaves between them.
Profile without_slivers(Profile profile, double grid) {
    const double step = usable_grid(std::array{profile}, grid);
    std::erase_if(profile.contours, [&](const std::vector<Vec2d>& contour) {
        double twice_area = 0, around = 0;
        for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
            const Vec2d a = contour[j] - contour[0], b = contour[i] - contour[0], side = b - a;
            twice_area += a.x * b.y - a.y * b.x;
            around += std::hypot(side.x, side.y);
        }
        return std::abs(twice_area) <= around * step;  // the mean width of a strip is twice its area by its outline
    });
    return profile;
}

}  // namespace

Profile section(const SolidTree& tree, std::uint32_t node, double tolerance, double grid) {
    const std::array sides{section_beside(tree, node, tolerance, grid, true),
                           section_beside(tree, node, tolerance, grid, false)};
    return without_slivers(profile_boolean(ProfileOp::unite, sides, grid), grid);
}

Profile shadow(const TriangleMesh& mesh, double grid) {
    // Each point of the shadow is covered by as many faces that look up as their border winds about it.
    std::multimap<std::uint32_t, std::uint32_t> links;
    std::map<Edge, int> border;
    for (const auto& t : mesh.triangles) {
        const Vec3d a = mesh.vertices[t[0]], n = cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
        if (!(n.z > 0)) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = t[i], to = t[(i + 1) % 3];
            border[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
        }
    }
    for (const auto& [edge, turns] : border)
        for (int i = 0; i < std::abs(turns); ++i)
            turns > 0 ? links.emplace(edge.first, edge.second) : links.emplace(edge.second, edge.first);
    const Profile loops{join(links, [&](std::uint32_t v) { return Vec2d{mesh.vertices[v].x, mesh.vertices[v].y}; })};
    return without_slivers(by_winding(loops, grid), grid);
}

}  // namespace cardioid::csg

#include "formats/povray/solids/coincidence.hpp"

#include <array>
#include <cmath>
#include <map>

namespace cardioid::formats::povray {

namespace {

/// Planes coincide within these: of the unit normal, and of the distance from the origin in diagonals of the scene.
constexpr double same_normal = 1e-5, same_distance = 1e-6;
/// Leaves of one solid grow by so many different amounts, this share apart.
constexpr std::uint32_t amounts = 8;
constexpr double apart = 0.1;

enum class Side { x_lo, x_hi, y_lo, y_hi, z_lo, z_hi, around };

/// A surface in numbers that are alike where surfaces coincide.
struct Surface {
    std::array<double, 7> numbers{};
    std::uint32_t node;
    Side side;
};

class SurfaceList {
public:
    SurfaceList(const SolidTree& solids, double diagonal) : solids_(solids), diagonal_(diagonal) {}

    void add(std::uint32_t node) {
        node_ = node;
        const Leaf& leaf = solids_.leaves[solids_.nodes[node].first];
        switch (leaf.kind) {
            case LeafKind::box:
                caps(leaf.to_world, 0, Side::x_lo, Side::x_hi);
                caps(leaf.to_world, 1, Side::y_lo, Side::y_hi);
                caps(leaf.to_world, 2, Side::z_lo, Side::z_hi);
                break;
            case LeafKind::cone:
                caps(leaf.to_world, 2, Side::z_lo, Side::z_hi);
                if (leaf.a == leaf.b) round(leaf.to_world, leaf.a, 2);
                break;
            case LeafKind::prism:
                caps(leaf.to_world, 2, Side::z_lo, Side::z_hi);
                walls(leaf);
                break;
            case LeafKind::half_space:
                plane(cross(leaf.to_world.column(0), leaf.to_world.column(1)), leaf.to_world.t, Side::around);
                break;
            case LeafKind::sphere:
                round(leaf.to_world, 1, -1);
                break;
            case LeafKind::revolution:
                rings(leaf);
                break;
            case LeafKind::mesh:
                triangles(leaf);
                break;
            case LeafKind::torus:
            case LeafKind::form:
                break;
        }
    }

    [[nodiscard]] const std::vector<Surface>& all() const { return all_; }

private:
    /// The plane through p with that normal, whichever way it points.
    void plane(Vec3d normal, Vec3d p, Side side) {
        const double size = length(normal);
        if (!(size > 0)) return;
        Vec3d n = normal / size;
        const double first = std::abs(n.x) > same_normal ? n.x : std::abs(n.y) > same_normal ? n.y : n.z;
        if (first < 0) n = -n;
        const double to_cell = 1 / same_normal;
        all_.push_back(
            {{n.x * to_cell, n.y * to_cell, n.z * to_cell, dot(n, p) / (diagonal_ * same_distance)}, node_, side});
    }
    void caps(const Affine& m, int axis, Side lo, Side hi) {
        const Vec3d normal = cross(m.column((axis + 1) % 3), m.column((axis + 2) % 3));
        plane(normal, m.t, lo);
        plane(normal, m.t + m.column(axis), hi);
    }
    void walls(const Leaf& leaf) {
        for (const auto& contour : solids_.profiles[leaf.data]->contours)
            for (std::size_t i = 0; i < contour.size(); ++i) {
                const Vec2d a = contour[i], b = contour[(i + 1) % contour.size()];
                const Vec3d p{a.x, a.y, 0}, q{b.x, b.y, 0}, top{a.x * leaf.a, a.y * leaf.a, 1};
                plane(cross(leaf.to_world.vector(q - p), leaf.to_world.vector(top - p)), leaf.to_world.point(p),
                      Side::around);
            }
    }
    void rings(const Leaf& leaf) {
        for (const auto& contour : solids_.profiles[leaf.data]->contours)
            for (std::size_t i = 0; i < contour.size(); ++i)
                if (contour[i].y == contour[(i + 1) % contour.size()].y)
                    plane(cross(leaf.to_world.column(0), leaf.to_world.column(1)),
                          leaf.to_world.point({0, 0, contour[i].y}), Side::around);
    }
    void triangles(const Leaf& leaf) {
        const TriangleMesh& mesh = *solids_.meshes[leaf.data];
        for (const auto& t : mesh.triangles) {
            const Vec3d p = leaf.to_world.point(mesh.vertices[t[0]]);
            plane(cross(leaf.to_world.point(mesh.vertices[t[1]]) - p, leaf.to_world.point(mesh.vertices[t[2]]) - p), p,
                  Side::around);
        }
    }
    /// A ball by its centre and size, a cylinder by the point of its axis (column `axis`) nearest the origin.
    void round(const Affine& m, double radius, int axis) {
        Vec3d place = m.t, along;
        if (axis >= 0) {
            along = normalize(m.column(axis));
            if (along.x + along.y * 1e-3 + along.z * 1e-6 < 0) along = -along;
            place = place - along * dot(place, along);
        }
        const double cell = diagonal_ * same_distance, to_cell = 1 / same_normal;
        all_.push_back({{place.x / cell, place.y / cell, place.z / cell, length(m.column(0)) * radius / cell,
                         along.x * to_cell, along.y * to_cell, along.z * to_cell + 3 * to_cell},
                        node_,
                        Side::around});
    }

    const SolidTree& solids_;
    double diagonal_;
    std::uint32_t node_ = 0;
    std::vector<Surface> all_;
};

using Cell = std::array<std::int64_t, 7>;

void mark(Growth& growth, Side side) {
    switch (side) {
        case Side::x_lo:
            growth.x.x = 1;
            break;
        case Side::x_hi:
            growth.x.y = 1;
            break;
        case Side::y_lo:
            growth.y.x = 1;
            break;
        case Side::y_hi:
            growth.y.y = 1;
            break;
        case Side::z_lo:
            growth.z.x = 1;
            break;
        case Side::z_hi:
            growth.z.y = 1;
            break;
        case Side::around:
            growth.around = true;
            break;
    }
}

std::vector<std::uint32_t> leaves_under(const SolidTree& solids, const SolidFacts& facts, std::uint32_t root) {
    std::vector<std::uint32_t> found, open{root};
    while (!open.empty()) {
        const std::uint32_t node = open.back();
        open.pop_back();
        if (solids.nodes[node].op == SolidOp::leaf) {
            found.push_back(node);
            continue;
        }
        const std::vector<std::uint32_t> children = facts.children(solids, node);
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return found;
}

}  // namespace

std::vector<Growth> find_growths(const SolidTree& solids, const SolidFacts& facts, double scene_diagonal, double by) {
    std::vector<Growth> growths(solids.nodes.size());
    for (const std::uint32_t root : solids.roots) {
        if (solids.nodes[root].op == SolidOp::leaf || facts.nodes[root].empty) continue;
        SurfaceList surfaces(solids, scene_diagonal);
        const std::vector<std::uint32_t> leaves = leaves_under(solids, facts, root);
        for (const std::uint32_t node : leaves) surfaces.add(node);
        // Two grids of cells, half a cell apart: what coincides shares a cell of one of them.
        for (const double shift : {0.0, 0.5}) {
            std::map<Cell, std::vector<const Surface*>> cells;
            for (const Surface& surface : surfaces.all()) {
                Cell cell;
                for (std::size_t i = 0; i < cell.size(); ++i) cell[i] = std::llround(surface.numbers[i] + shift);
                cells[cell].push_back(&surface);
            }
            for (const auto& [cell, same] : cells)
                for (const Surface* surface : same) {
                    const SolidFacts::Node& fact = facts.nodes[surface->node];
                    if ((fact.cuts > 0 || fact.abuts) && same.front()->node != same.back()->node)
                        mark(growths[surface->node], surface->side);
                }
        }
        for (std::uint32_t i = 0; i < leaves.size(); ++i) {
            const int cuts = std::max(1, facts.nodes[leaves[i]].cuts);
            Growth& growth = growths[leaves[i]];
            if (growth.around || growth.x != Vec2d{} || growth.y != Vec2d{} || growth.z != Vec2d{})
                growth.by = by * (cuts + apart * (i % amounts));
        }
    }
    return growths;
}

}  // namespace cardioid::formats::povray

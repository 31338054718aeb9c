#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "rt_core/api/math.hpp"

namespace cardioid::photon {

/// A ball on a surface: where a cache point is of use.
struct Reach {
    Vec3 p;
    Vec3 n;
    float radius = 0;  ///< > 0
};

/// Finds the balls around a place: an octree whose leaves keep copies of all balls that touch them, eight to a group,
/// so that a lookup is one way down and a straight run through memory. Read-only once built; any thread may ask.
class CacheIndex {
public:
    CacheIndex() = default;
    /// O(n log n).
    explicit CacheIndex(std::span<const Reach> reaches);

    /// Calls visit(i, t) for every ball i that p, n is within, in the order of the leaf. t in [0, 1) is
    /// |p - p_i| / radius_i + sqrt(1 - n.n_i) / `turn`: equation 6 of ARL-TR-3608 as a share of what is allowed.
    /// Left out are those whose plane p is off by more than a tenth of their radius.
    template <class Visit>
    void around(Vec3 p, Vec3 n, float turn, Visit&& visit) const noexcept;

    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return nodes_.capacity() * sizeof(Node) + groups_.capacity() * sizeof(Group);
    }

private:
    static constexpr int lanes = 8, deepest = 16;
    /// Height over its plane that a ball is of use for, as a share of its radius.
    static constexpr float flatness = 0.1F;

    struct Node {
        std::uint32_t first = 0;  ///< child, or group
        std::uint32_t groups = inner;
        static constexpr std::uint32_t inner = 0xFFFFFFFFU;
        [[nodiscard]] bool is_leaf() const { return groups != inner; }
    };
    struct alignas(32) Group {
        float x[lanes], y[lanes], z[lanes], nx[lanes], ny[lanes], nz[lanes], per_radius[lanes];
        std::uint32_t index[lanes];
    };
    struct Cell {
        Vec3 lo;
        float size;
    };

    void split(std::size_t node, const Cell& cell, std::vector<std::uint32_t> members, int depth,
               std::span<const Reach> reaches);
    void fill(std::size_t node, const std::vector<std::uint32_t>& members, std::span<const Reach> reaches);
    [[nodiscard]] const Node* leaf(Vec3 p) const noexcept;

    std::vector<Node> nodes_;
    std::vector<Group> groups_;
    Cell root_{};
    float per_cell_ = 0;  ///< smallest cells a unit of length
};

template <class Visit>
void CacheIndex::around(Vec3 p, Vec3 n, float turn, Visit&& visit) const noexcept {
    const Node* node = leaf(p);
    if (!node) return;
    const float per_turn = 1 / turn;
    for (const Group *g = groups_.data() + node->first, *end = g + node->groups; g != end; ++g) {
        float t[lanes], off[lanes];
        for (int i = 0; i < lanes; ++i) {
            const float x = p.x - g->x[i], y = p.y - g->y[i], z = p.z - g->z[i];
            const float cosine = n.x * g->nx[i] + n.y * g->ny[i] + n.z * g->nz[i];
            const float distance = std::sqrt(x * x + y * y + z * z) * g->per_radius[i];
            t[i] = distance + std::sqrt(std::max(0.0F, 1 - cosine)) * per_turn;
            const float height = x * (n.x + g->nx[i]) + y * (n.y + g->ny[i]) + z * (n.z + g->nz[i]);
            off[i] = std::abs(height) * g->per_radius[i];
        }
        for (int i = 0; i < lanes; ++i)
            if (t[i] < 1 && off[i] < 2 * flatness) visit(g->index[i], t[i]);
    }
}

}  // namespace cardioid::photon

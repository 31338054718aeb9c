#pragma once
#include <bit>
#include <span>
#include <vector>

#include "photon/cache/ball_group.hpp"

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
    explicit CacheIndex(std::span<const Reach> reaches) { rebuild(reaches); }

    /// Forgets what it had; O(n log n), on all threads, the same for any number of them.
    void rebuild(std::span<const Reach> reaches);

    /// Calls visit(i, t) for every ball i that p, n is within, in the order of the leaf. t in [0, 1) is
    /// |p - p_i| / radius_i + sqrt(1 - n.n_i) / `turn`: equation 6 of ARL-TR-3608 as a share of what is allowed.
    /// Left out are those whose plane p is off by more than a tenth of their radius.
    template <class Visit>
    void around(Vec3 p, Vec3 n, float turn, Visit&& visit) const noexcept;

    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return nodes_.capacity() * sizeof(Node) + groups_.capacity() * sizeof(BallGroup);
    }

private:
    static constexpr int deepest = 16;

    struct Node {
        std::uint32_t first = 0;  ///< child, or group
        std::uint32_t groups = inner;
        static constexpr std::uint32_t inner = 0xFFFFFFFFU;
        [[nodiscard]] bool is_leaf() const { return groups != inner; }
    };
    struct Cell {
        Vec3 lo;
        float size;
    };
    class Builder;

    [[nodiscard]] const Node* leaf(Vec3 p) const noexcept;

    std::vector<Node> nodes_;
    std::vector<BallGroup> groups_;
    Cell root_{};
    float per_cell_ = 0;  ///< smallest cells a unit of length
    ScanBalls scan_ = quickest_scan_balls();
};

template <class Visit>
void CacheIndex::around(Vec3 p, Vec3 n, float turn, Visit&& visit) const noexcept {
    const Node* node = leaf(p);
    if (!node) return;
    const BallQuery query{p, n, 1 / turn};
    for (const BallGroup *g = groups_.data() + node->first, *end = g + node->groups; g != end; ++g) {
        float t[BallGroup::lanes];
        for (unsigned within = scan_(*g, query, t); within != 0; within &= within - 1) {
            const int i = std::countr_zero(within);
            visit(g->index[i], t[i]);
        }
    }
}

}  // namespace cardioid::photon

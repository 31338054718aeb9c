#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "photon/map/tree/scan.hpp"
#include "photon/map/tree/untouched.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::photon {

/// A split or a bucket; 8 bytes. The left child of a split is the node behind it.
class KdNode {
public:
    static KdNode bucket(Bucket b) { return {b.first, b.count << 2 | leaf_axis}; }
    /// Left are points with a coordinate <= `at`, right >= `at`; `right` is as many nodes further.
    static KdNode split(unsigned axis, float at, std::uint32_t right) {
        return {std::bit_cast<std::uint32_t>(at), right << 2 | axis};
    }
    [[nodiscard]] bool is_bucket() const { return (bits_ & 3) == leaf_axis; }
    [[nodiscard]] Bucket bucket() const { return {word_, bits_ >> 2}; }
    [[nodiscard]] int axis() const { return static_cast<int>(bits_ & 3); }
    [[nodiscard]] float at() const { return std::bit_cast<float>(word_); }
    [[nodiscard]] std::uint32_t right() const { return bits_ >> 2; }

private:
    static constexpr std::uint32_t leaf_axis = 3;
    KdNode(std::uint32_t word, std::uint32_t bits) : word_(word), bits_(bits) {}
    std::uint32_t word_, bits_;
};
static_assert(sizeof(KdNode) == 8);

/// A point on its way into a tree.
struct KdKey {
    float p[3];
    std::uint32_t index;  ///< in the caller's list
    [[nodiscard]] Vec3 position() const { return {p[0], p[1], p[2]}; }
};

struct KdLayout {
    std::vector<KdNode> nodes;    ///< the first is the root; none without points
    UntouchedVector<KdKey> keys;  ///< in the order of the tree; within a bucket in that of the caller
    Vec3 lo, hi;                  ///< box around all points
};

/// Calls body(first, last) for pieces of [0, n), on all threads where there are several. Pieces are of whole groups.
template <class Body>
void for_chunks(std::size_t n, const Body& body) {
    constexpr std::size_t chunk = std::size_t{1024} * PointGroup::size;
    if (n <= chunk) {
        body(0, n);
        return;
    }
    parallel_for(static_cast<std::int64_t>((n + chunk - 1) / chunk), [&](std::int64_t i) {
        const std::size_t first = static_cast<std::size_t>(i) * chunk;
        body(first, std::min(first + chunk, n));
    });
}

/// Lays out a kd-tree with at most 32 points a bucket. A box around the points of a node is halved across its longest
/// side (the sliding midpoint of Maneewongvatana and Mount 1999, slid at both ends), or split at the median by
/// (coordinate, index) where halving could make the tree deeper than ceil(log2 N) + 1. Every partition keeps the order
/// of the keys, so the result depends on the keys alone: not on threads, and laying out a laid-out tree changes
/// nothing. O(N log N). Throws Error(bad_input) where a position is not finite, Error(limit) past 2^30 points.
[[nodiscard]] KdLayout lay_out_kd(UntouchedVector<KdKey> keys);

/// The most splits on a path of a tree over that many points.
[[nodiscard]] int kd_depth_bound(std::size_t points) noexcept;

}  // namespace cardioid::photon

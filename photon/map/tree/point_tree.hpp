#pragma once
#include <span>
#include <utility>

#include "photon/map/tree/kd_tree.hpp"

namespace cardioid::photon {

/// A kd-tree over points of one kind: photons, cache points, radiance photons (ARL-TR-3608, section 5: the same code
/// for both). A Point has `p` (Vec3), `n` (encode_direction), `region`, and, found by its namespace, payload_of(point)
/// with whatever else there is, trivially copyable. Read-only once built: any thread may query it.
template <class Point>
class PointTree : public KdTree {
public:
    using Payload = decltype(payload_of(std::declval<const Point&>()));

    PointTree() = default;
    /// O(N log N) on all threads; the result does not depend on how many. Throws Error(bad_input) where a position is
    /// not finite, Error(limit) past 2^30 points. Needs 48 bytes a point on top of the points while it builds.
    explicit PointTree(std::span<const Point> points) : PointTree(points, lay_out_kd(keys_of(points))) {}

    /// Of the point i in the tree's order; indices are those that queries find.
    [[nodiscard]] const Payload& payload(std::uint32_t i) const noexcept { return payloads_[i]; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return KdTree::memory_bytes() + payloads_.capacity() * sizeof(Payload);
    }

private:
    PointTree(std::span<const Point> points, KdLayout&& layout) {
        payloads_.resize(points.size());
        for_chunks(points.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) payloads_[i] = payload_of(points[layout.keys[i].index]);
        });
        static_cast<KdTree&>(*this) = KdTree(
            std::move(layout), [&](std::uint32_t i) { return points[i].n; },
            [&](std::uint32_t i) { return points[i].region; });
    }

    static UntouchedVector<KdKey> keys_of(std::span<const Point> points) {
        UntouchedVector<KdKey> keys(points.size());
        for_chunks(points.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const Vec3 p = points[i].p;
                keys[i] = {{p.x, p.y, p.z}, static_cast<std::uint32_t>(i)};
            }
        });
        return keys;
    }

    UntouchedVector<Payload> payloads_;
};

}  // namespace cardioid::photon

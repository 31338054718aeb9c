#pragma once
#include <cmath>
#include <limits>

#include "photon/map/tree/kd_tree.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::photon {

template <class Normal, class Region>
KdTree::KdTree(KdLayout&& layout, const Normal& normal, const Region& region)
    : nodes_(std::move(layout.nodes)),
      groups_((layout.keys.size() + PointGroup::size - 1) / PointGroup::size),
      size_(static_cast<std::uint32_t>(layout.keys.size())),
      lo_(layout.lo),
      hi_(layout.hi) {
    if (!groups_.empty()) groups_.back() = {};  // places past the last point are looked at, if not used
    for_chunks(layout.keys.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            PointGroup& g = groups_[i / PointGroup::size];
            const std::size_t lane = i % PointGroup::size;
            const KdKey& key = layout.keys[i];
            g.x[lane] = key.p[0], g.y[lane] = key.p[1], g.z[lane] = key.p[2];
            g.n[lane] = normal(key.index);
            g.region[lane] = region(key.index);
        }
    });
}

namespace detail {

/// The smallest float above the square of a radius: what squared distances are to be below.
inline float above_square(float radius) {
    return std::nextafter(radius * radius, std::numeric_limits<float>::infinity());
}

/// Removes the candidates from `first` on that `keep` refuses.
template <class Keep>
std::uint32_t filter(Neighbours& out, std::uint32_t first, std::uint32_t size, const Keep& keep) noexcept {
    if constexpr (std::is_same_v<Keep, KeepAll>) return size;
    std::uint32_t kept = first;
    for (std::uint32_t i = first; i < size; ++i) {
        const float d2 = out.d2[i];
        const std::uint32_t index = out.index[i];
        if (!keep(index, d2)) continue;
        out.d2[kept] = d2;
        out.index[kept++] = index;
    }
    return kept;
}

/// Moves the farthest to the end.
inline void farthest_last(Neighbours& out) noexcept {
    std::uint32_t farthest = 0;
    for (std::uint32_t i = 1; i < out.size; ++i)
        if (out.d2[i] >= out.d2[farthest]) farthest = i;
    if (out.size > 0) put_last(out.d2, out.index, farthest, out.size - 1);
}

}  // namespace detail

template <class Look>
void KdTree::walk(Vec3 p, float r2, const Look& look) const noexcept {
    /// A node and its cell's distance from p along each axis. Their squares are summed in the order of the scan, so no
    /// point is ever nearer than its cell, not even by rounding.
    struct Pending {
        const KdNode* node;
        float d2, x, y, z;
    };
    constexpr int deepest = 33;
    Pending stack[deepest];
    int pending = 0;
    if (nodes_.empty()) return;
    const auto outside = [](float at, float lo, float hi) { return std::max(std::max(lo - at, at - hi), 0.0F); };
    const auto square = [](const Pending& c) { return c.x * c.x + c.y * c.y + c.z * c.z; };
    Pending at{nodes_.data(), 0, outside(p.x, lo_.x, hi_.x), outside(p.y, lo_.y, hi_.y), outside(p.z, lo_.z, hi_.z)};
    at.d2 = square(at);
    for (;;) {
        if (at.d2 < r2) {
            while (!at.node->is_bucket()) {
                const KdNode& node = *at.node;
                const int axis = node.axis();
                const float beyond = p[axis] - node.at();
                const KdNode* const left = &node + 1;
                const KdNode* const right = &node + node.right();
                Pending far = at;
                far.node = beyond < 0 ? right : left;
                (axis == 0 ? far.x : axis == 1 ? far.y : far.z) = beyond;
                far.d2 = square(far);
                if (far.d2 < r2) stack[pending++] = far;
                at.node = beyond < 0 ? left : right;
            }
            r2 = look(at.node->bucket(), r2);
        }
        if (pending == 0) return;
        at = stack[--pending];
    }
}

template <class Keep>
void KdTree::nearest(const PointQuery& query, std::uint32_t k, Neighbours& out, const Keep& keep) const noexcept {
    out.size = 0;
    k = std::min(k, Neighbours::max_k);
    if (k == 0) return;
    const ScanQuery scan(query);
    bool full = false;
    walk(query.p, detail::above_square(query.max_radius), [&](Bucket bucket, float r2) {
        const std::uint32_t size =
            out.size + kernels_->scan(groups_.data(), bucket, scan, r2, out.d2 + out.size, out.index + out.size);
        out.size = detail::filter(out, out.size, size, keep);
        // The first k bound the radius at once; later ones wait until selecting among them pays.
        if (out.size < (full ? 2 * k : k)) return r2;
        full = true;
        r2 = kernels_->keep_smallest(out.d2, out.index, out.size, k);
        out.size = k;
        return r2;
    });
    if (!full) {
        detail::farthest_last(out);
    } else if (out.size > k) {
        kernels_->keep_smallest(out.d2, out.index, out.size, k);
        out.size = k;
    }
}

template <class Keep>
Nearest KdTree::nearest(const PointQuery& query, const Keep& keep) const noexcept {
    Nearest best;
    const ScanQuery scan(query);
    alignas(64) float d2[64];
    alignas(64) std::uint32_t index[64];
    walk(query.p, detail::above_square(query.max_radius), [&](Bucket bucket, float r2) {
        const std::uint32_t found = kernels_->scan(groups_.data(), bucket, scan, r2, d2, index);
        for (std::uint32_t i = 0; i < found; ++i)
            if (d2[i] < r2 && keep(index[i], d2[i])) {
                best = {index[i], d2[i]};
                r2 = d2[i];
            }
        return r2;
    });
    return best;
}

template <class Visit>
void KdTree::visit_within(const PointQuery& query, const Visit& visit) const noexcept {
    const ScanQuery scan(query);
    alignas(64) float d2[64];
    alignas(64) std::uint32_t index[64];
    walk(query.p, detail::above_square(query.max_radius), [&](Bucket bucket, float r2) {
        const std::uint32_t found = kernels_->scan(groups_.data(), bucket, scan, r2, d2, index);
        for (std::uint32_t i = 0; i < found; ++i) visit(index[i], d2[i]);
        return r2;
    });
}

template <class Visit>
void KdTree::visit_reaching(const PointQuery& query, const KdReach& reach, const Visit& visit) const noexcept {
    /// A node and its cell's distance from the place along each axis, as in walk().
    struct Pending {
        const KdNode* node;
        Vec3 away;
    };
    constexpr int deepest = 33;
    Pending stack[deepest];
    int pending = 0;
    if (nodes_.empty()) return;
    const ScanQuery scan(query);
    alignas(64) float d2[64];
    alignas(64) std::uint32_t index[64];
    const auto square_of = [&](const KdNode* node) {
        const float r = reach[static_cast<std::size_t>(node - nodes_.data())];
        return r * r;
    };
    const Vec3 zero;
    for (Pending at{nodes_.data(), max(max(lo_ - query.p, query.p - hi_), zero)};;) {
        float r2 = square_of(at.node);
        while (dot(at.away, at.away) < r2 && !at.node->is_bucket()) {
            const KdNode& node = *at.node;
            const float beyond = query.p[node.axis()] - node.at();
            const KdNode* const left = &node + 1;
            const KdNode* const right = &node + node.right();
            Pending& far = stack[pending++];
            far = {beyond < 0 ? right : left, at.away};
            far.away[node.axis()] = beyond;
            at.node = beyond < 0 ? left : right;
            r2 = square_of(at.node);
        }
        if (at.node->is_bucket() && dot(at.away, at.away) < r2) {
            const std::uint32_t found = kernels_->scan(groups_.data(), at.node->bucket(), scan, r2, d2, index);
            for (std::uint32_t i = 0; i < found; ++i) visit(index[i], d2[i], r2);
        }
        if (pending == 0) return;
        at = stack[--pending];
    }
}

}  // namespace cardioid::photon

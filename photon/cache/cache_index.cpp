#include "photon/cache/cache_index.hpp"

#include <algorithm>
#include <cmath>

namespace cardioid::photon {

namespace {

/// Balls that a leaf may hold without being split further.
constexpr std::size_t few = 8;
/// A place that no ball reaches.
constexpr float nowhere = 1e30F;

bool touches(const Reach& reach, Vec3 lo, float size) {
    const Vec3 hi = lo + Vec3{size, size, size};
    const Vec3 nearest = max(lo, min(hi, reach.p));
    const Vec3 d = reach.p - nearest;
    return dot(d, d) < reach.radius * reach.radius;
}

}  // namespace

CacheIndex::CacheIndex(std::span<const Reach> reaches) {
    if (reaches.empty()) return;
    Vec3 lo = reaches[0].p, hi = lo;
    std::vector<std::uint32_t> all(reaches.size());
    for (std::size_t i = 0; i < reaches.size(); ++i) {
        const Vec3 r{reaches[i].radius, reaches[i].radius, reaches[i].radius};
        lo = min(lo, reaches[i].p - r);
        hi = max(hi, reaches[i].p + r);
        all[i] = static_cast<std::uint32_t>(i);
    }
    // A little larger, so that rounding leaves no place outside.
    const float size = max_component(hi - lo) * (1 + 1e-5F);
    root_ = {lo, size};
    per_cell_ = static_cast<float>(1 << deepest) / size;
    nodes_.emplace_back();
    split(0, root_, std::move(all), 0, reaches);
}

void CacheIndex::split(std::size_t node, const Cell& cell, std::vector<std::uint32_t> members, int depth,
                       std::span<const Reach> reaches) {
    float radii = 0;
    for (const std::uint32_t i : members) radii += reaches[i].radius;
    // Cells much smaller than what they hold only multiply the copies.
    if (members.size() <= few || depth == deepest || cell.size * static_cast<float>(members.size()) < radii)
        return fill(node, members, reaches);
    const std::size_t first = nodes_.size();
    nodes_[node].first = static_cast<std::uint32_t>(first);
    nodes_.resize(first + 8);
    const float half = cell.size / 2;
    for (std::size_t child = 0; child < 8; ++child) {
        const Vec3 corner{child & 1 ? half : 0, child & 2 ? half : 0, child & 4 ? half : 0};
        const Cell part{cell.lo + corner, half};
        std::vector<std::uint32_t> inside;
        for (const std::uint32_t i : members)
            if (touches(reaches[i], part.lo, half)) inside.push_back(i);
        split(first + child, part, std::move(inside), depth + 1, reaches);
    }
}

void CacheIndex::fill(std::size_t node, const std::vector<std::uint32_t>& members, std::span<const Reach> reaches) {
    nodes_[node].first = static_cast<std::uint32_t>(groups_.size());
    nodes_[node].groups = static_cast<std::uint32_t>((members.size() + lanes - 1) / lanes);
    for (std::size_t begin = 0; begin < members.size(); begin += lanes) {
        Group group{};
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            group.x[lane] = nowhere;
            group.per_radius[lane] = 1;
            if (begin + lane >= members.size()) continue;
            const Reach& reach = reaches[members[begin + lane]];
            group.x[lane] = reach.p.x, group.y[lane] = reach.p.y, group.z[lane] = reach.p.z;
            group.nx[lane] = reach.n.x, group.ny[lane] = reach.n.y, group.nz[lane] = reach.n.z;
            group.per_radius[lane] = 1 / reach.radius;
            group.index[lane] = members[begin + lane];
        }
        groups_.push_back(group);
    }
}

const CacheIndex::Node* CacheIndex::leaf(Vec3 p) const noexcept {
    const Vec3 q = (p - root_.lo) * per_cell_;
    constexpr float end = 1 << deepest;
    if (nodes_.empty() || !(q.x >= 0 && q.y >= 0 && q.z >= 0 && q.x < end && q.y < end && q.z < end)) return nullptr;
    const auto x = static_cast<std::uint32_t>(q.x), y = static_cast<std::uint32_t>(q.y),
               z = static_cast<std::uint32_t>(q.z);
    const Node* node = nodes_.data();
    for (int bit = deepest - 1; !node->is_leaf(); --bit)
        node = nodes_.data() + node->first + ((x >> bit & 1) | (y >> bit & 1) << 1 | (z >> bit & 1) << 2);
    return node;
}

}  // namespace cardioid::photon

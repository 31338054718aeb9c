#include "photon/cache/cache_index.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "rt_core/api/parallel.hpp"

namespace cardioid::photon {

namespace {

/// Balls that a leaf may hold without being split further.
constexpr std::size_t few = 8;
/// Balls that several threads are worth waking for.
constexpr std::size_t many = 1000;
/// A place that no ball reaches.
constexpr float nowhere = 1e30F;

/// Of the eight halves of a cube from lo to hi, as bits, those that the ball touches.
unsigned touched_parts(const Reach& ball, Vec3 lo, Vec3 middle, Vec3 hi) {
    const auto square = [](float x) { return x * x; };
    float d2[3][2];
    for (int axis = 0; axis < 3; ++axis) {
        const float p = ball.p[axis];
        d2[axis][0] = square(std::max({lo[axis] - p, p - middle[axis], 0.0F}));
        d2[axis][1] = square(std::max({middle[axis] - p, p - hi[axis], 0.0F}));
    }
    const float r2 = square(ball.radius);
    unsigned parts = 0;
    for (unsigned part = 0; part < 8; ++part) {
        const float distance2 = d2[0][part & 1] + d2[1][part >> 1 & 1] + d2[2][part >> 2];
        parts |= static_cast<unsigned>(distance2 < r2) << part;
    }
    return parts;
}

}  // namespace

class CacheIndex::Builder {
public:
    explicit Builder(std::span<const Reach> reaches) : reaches_(reaches) { nodes_.emplace_back(); }

    /// The tree of the members below a cell of that depth.
    void build(std::vector<std::uint32_t> members, const Cell& cell, int depth) {
        members_ = std::move(members);
        split(0, cell, 0, depth);
    }
    /// The same of all balls, each eighth of the cell by itself.
    void build_in_parts(const Cell& cell) {
        const float half = cell.size / 2;
        const Vec3 middle = cell.lo + Vec3{half, half, half}, hi = middle + Vec3{half, half, half};
        std::vector<std::uint32_t> members[8];
        for (std::uint32_t i = 0; i < reaches_.size(); ++i)
            for (unsigned touched = touched_parts(reaches_[i], cell.lo, middle, hi); touched != 0;
                 touched &= touched - 1)
                members[std::countr_zero(touched)].push_back(i);
        std::vector<Builder> parts(8, Builder(reaches_));
        parallel_for(8, [&](std::int64_t part) {
            const Vec3 corner{part & 1 ? half : 0, part & 2 ? half : 0, part & 4 ? half : 0};
            parts[static_cast<std::size_t>(part)].build(std::move(members[part]), {cell.lo + corner, half}, 1);
        });
        nodes_[0].first = 1;
        nodes_.resize(9);
        for (std::size_t part = 0; part < 8; ++part) append(parts[part], 1 + part);
    }
    void finish(CacheIndex& index) {
        index.nodes_ = std::move(nodes_);
        index.groups_ = std::move(groups_);
    }

private:
    /// Puts a part's root in the node, and all else of it at the end.
    void append(const Builder& part, std::size_t root) {
        const std::size_t node_base = nodes_.size() - 1, group_base = groups_.size();
        const auto moved = [&](Node node) {
            node.first += static_cast<std::uint32_t>(node.is_leaf() ? group_base : node_base);
            return node;
        };
        nodes_[root] = moved(part.nodes_[0]);
        for (std::size_t i = 1; i < part.nodes_.size(); ++i) nodes_.push_back(moved(part.nodes_[i]));
        groups_.insert(groups_.end(), part.groups_.begin(), part.groups_.end());
    }

    /// Makes a node of the members from `begin` on, which stand at the end of the list.
    void split(std::size_t node, const Cell& cell, std::size_t begin, int depth) {
        const std::size_t end = members_.size();
        float radii = 0;
        for (std::size_t i = begin; i < end; ++i) radii += reaches_[members_[i]].radius;
        const std::size_t count = end - begin;
        // Cells much smaller than what they hold only multiply the copies.
        if (count <= few || depth == deepest || cell.size * static_cast<float>(count) < radii) return fill(node, begin);
        const std::size_t first = nodes_.size();
        nodes_[node].first = static_cast<std::uint32_t>(first);
        nodes_.resize(first + 8);
        const float half = cell.size / 2;
        const Vec3 middle = cell.lo + Vec3{half, half, half}, hi = middle + Vec3{half, half, half};
        parts_.resize(end);
        for (std::size_t i = begin; i < end; ++i)
            parts_[i] = static_cast<std::uint8_t>(touched_parts(reaches_[members_[i]], cell.lo, middle, hi));
        for (unsigned part = 0; part < 8; ++part) {
            for (std::size_t i = begin; i < end; ++i)
                if (parts_[i] >> part & 1) members_.push_back(members_[i]);
            const Vec3 corner{part & 1 ? half : 0, part & 2 ? half : 0, part & 4 ? half : 0};
            split(first + part, {cell.lo + corner, half}, end, depth + 1);
            members_.resize(end);
        }
    }

    void fill(std::size_t node, std::size_t begin) {
        constexpr auto lanes = static_cast<std::size_t>(BallGroup::lanes);
        const std::size_t end = members_.size();
        nodes_[node].first = static_cast<std::uint32_t>(groups_.size());
        nodes_[node].groups = static_cast<std::uint32_t>((end - begin + lanes - 1) / lanes);
        for (; begin < end; begin += lanes) {
            BallGroup& group = groups_.emplace_back();
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                group.x[lane] = nowhere;
                group.per_radius[lane] = 1;
                if (begin + lane >= end) continue;
                const Reach& reach = reaches_[members_[begin + lane]];
                group.x[lane] = reach.p.x, group.y[lane] = reach.p.y, group.z[lane] = reach.p.z;
                group.nx[lane] = reach.n.x, group.ny[lane] = reach.n.y, group.nz[lane] = reach.n.z;
                group.per_radius[lane] = 1 / reach.radius;
                group.index[lane] = members_[begin + lane];
            }
        }
    }

    std::span<const Reach> reaches_;
    std::vector<Node> nodes_;
    std::vector<BallGroup> groups_;
    std::vector<std::uint32_t> members_;  ///< of the node in work and of those above it
    std::vector<std::uint8_t> parts_;     ///< of each member, what it touches of its node
};

void CacheIndex::rebuild(std::span<const Reach> reaches) {
    nodes_.clear();
    groups_.clear();
    if (reaches.empty()) return;
    Vec3 lo = reaches[0].p, hi = lo;
    for (const Reach& reach : reaches) {
        const Vec3 r{reach.radius, reach.radius, reach.radius};
        lo = min(lo, reach.p - r);
        hi = max(hi, reach.p + r);
    }
    // A little larger, so that rounding leaves no place outside.
    const float size = max_component(hi - lo) * (1 + 1e-5F);
    root_ = {lo, size};
    per_cell_ = static_cast<float>(1 << deepest) / size;
    Builder builder(reaches);
    if (reaches.size() >= many) {
        builder.build_in_parts(root_);
    } else {
        std::vector<std::uint32_t> all(reaches.size());
        std::iota(all.begin(), all.end(), 0U);
        builder.build(std::move(all), root_, 0);
    }
    builder.finish(*this);
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

#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "rt_core/api/math.hpp"

namespace cardioid::photon {

/// Balls, found by what overlaps them, while more are added: the octree of Ward et al. 1988, where each ball stands in
/// the smallest cell that is at least as wide as it and has its middle. Writing is for one thread.
class NeighbourTree {
public:
    /// `root` is a cube around all middles; size > 0.
    NeighbourTree(Vec3 lo, float size) : lo_(lo), size_(size) { nodes_.emplace_back(); }

    /// Adds the ball with the next number: 0, 1, 2 ...
    void add(Vec3 p, float radius);
    /// Calls visit(i) for the balls that may overlap that one, in an order that depends on what was added alone.
    template <class Visit>
    void overlapping(Vec3 p, float radius, Visit&& visit) const {
        overlapping(0, lo_, size_, p, radius, visit);
    }

private:
    static constexpr int deepest = 24;
    struct Node {
        std::array<std::uint32_t, 8> children{};  ///< 0: none
        std::vector<std::uint32_t> balls;
    };

    template <class Visit>
    void overlapping(std::uint32_t node, Vec3 lo, float size, Vec3 p, float radius, Visit& visit) const {
        // What stands in a cell sticks out by half its width at most.
        const float room = radius + size / 2;
        const Vec3 outside = max(lo - p, p - lo - Vec3{size, size, size});
        if (max_component(outside) > room) return;
        for (const std::uint32_t i : nodes_[node].balls) visit(i);
        const float half = size / 2;
        for (unsigned child = 0; child < 8; ++child)
            if (const std::uint32_t next = nodes_[node].children[child])
                overlapping(next, lo + corner(child, half), half, p, radius, visit);
    }
    static Vec3 corner(unsigned child, float half) {
        return {child & 1 ? half : 0, child & 2 ? half : 0, child & 4 ? half : 0};
    }

    Vec3 lo_;
    float size_;
    std::vector<Node> nodes_;
    std::uint32_t count_ = 0;
};

}  // namespace cardioid::photon

#include "photon/cache/neighbour_tree.hpp"

namespace cardioid::photon {

void NeighbourTree::add(Vec3 p, float radius) {
    std::uint32_t node = 0;
    Vec3 lo = lo_;
    float size = size_;
    for (int depth = 0; depth < deepest && size >= 4 * radius; ++depth) {
        size /= 2;
        const unsigned child =
            (p.x >= lo.x + size ? 1U : 0U) | (p.y >= lo.y + size ? 2U : 0U) | (p.z >= lo.z + size ? 4U : 0U);
        lo += corner(child, size);
        if (nodes_[node].children[child] == 0) {
            nodes_[node].children[child] = static_cast<std::uint32_t>(nodes_.size());
            nodes_.emplace_back();
        }
        node = nodes_[node].children[child];
    }
    nodes_[node].balls.push_back(count_++);
}

}  // namespace cardioid::photon

#pragma once
#include <vector>

#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

/// Calls visit(leaf) for every leaf below `node`, from first to last, without recursion.
template <class Visit>
void for_each_leaf(const SolidTree& tree, std::uint32_t node, Visit&& visit) {
    std::vector<std::uint32_t> rest{node};
    while (!rest.empty()) {
        const SolidNode& at = tree.nodes[rest.back()];
        rest.pop_back();
        if (at.op == SolidOp::leaf) {
            visit(tree.leaves[at.first]);
            continue;
        }
        for (std::uint32_t c = at.count; c-- > 0;) rest.push_back(tree.children[at.first + c]);
    }
}

/// The largest parts whose union is `node`, in order: what is below its unions.
inline std::vector<std::uint32_t> united_parts(const SolidTree& tree, std::uint32_t node) {
    std::vector<std::uint32_t> rest{node}, out;
    while (!rest.empty()) {
        const std::uint32_t index = rest.back();
        rest.pop_back();
        const SolidNode& at = tree.nodes[index];
        if (at.op != SolidOp::unite) {
            out.push_back(index);
            continue;
        }
        for (std::uint32_t c = at.count; c-- > 0;) rest.push_back(tree.children[at.first + c]);
    }
    return out;
}

}  // namespace cardioid::csg

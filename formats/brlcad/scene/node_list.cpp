#include "formats/brlcad/scene/node_list.hpp"

namespace cardioid::formats::brlcad {

void NodeList::join(Step::Op op, const NodeList& right, SolidTree& tree) {
    if (op == Step::Op::exclusive) {
        // The union without what both share.
        NodeList both = *this;
        both.join(Step::Op::intersect, right, tree);
        join(Step::Op::unite, right, tree);
        return join(Step::Op::subtract, both, tree);
    }
    if (op == Step::Op::intersect && (nodes_.empty() || right.nodes_.empty())) return nodes_.clear();
    if (right.nodes_.empty()) return;
    if (nodes_.empty()) {
        if (op == Step::Op::unite) *this = right;
        return;
    }
    const SolidOp wanted = op == Step::Op::unite       ? SolidOp::unite
                           : op == Step::Op::intersect ? SolidOp::intersect
                                                       : SolidOp::subtract;
    if (nodes_.size() > 1 && op_ != wanted) nodes_ = {*node(tree)};
    op_ = wanted;
    // a u (b u c) and a - (b u c) are one list, too.
    if (right.nodes_.size() > 1 && right.op_ == SolidOp::unite && wanted != SolidOp::intersect)
        nodes_.insert(nodes_.end(), right.nodes_.begin(), right.nodes_.end());
    else
        nodes_.push_back(*right.node(tree));
}

void NodeList::complement(SolidTree& tree) {
    const Affine upside_down{{Vec3d{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, {}};
    const std::uint32_t lower = tree.add_leaf({.kind = LeafKind::half_space});
    const std::uint32_t upper = tree.add_leaf({.kind = LeafKind::half_space, .to_world = upside_down});
    NodeList all{lower};
    all.join(Step::Op::unite, NodeList(upper), tree);
    all.join(Step::Op::subtract, *this, tree);
    *this = all;
}

std::optional<std::uint32_t> NodeList::node(SolidTree& tree) const {
    if (nodes_.empty()) return std::nullopt;
    return nodes_.size() == 1 ? nodes_[0] : tree.add_node(op_, nodes_);
}

}  // namespace cardioid::formats::brlcad

#include "csg/region/gates.hpp"

#include <algorithm>

namespace cardioid::csg {
namespace {

/// A node of the normal form while it is built; children stand before parents.
struct Draft {
    enum class Op : std::uint8_t { leaf, all, any } op;
    bool negated = false;  ///< leaves only
    std::uint32_t leaf = 0;
    std::vector<std::uint32_t> children;
    Box3d bounds;         ///< where it can be true
    Box3d matters;        ///< where its value can change the root's
    bool never = false;   ///< false everywhere
    bool always = false;  ///< true wherever its parent can be
};

/// One step of the walk over the tree: a node to be drafted under a drafted parent.
struct Pending {
    std::uint32_t node;
    bool negated;
    std::uint32_t parent;
};

class Drafter {
public:
    Drafter(const SolidTree& tree, const std::vector<Box3d>& leaf_boxes) : tree_(tree), leaf_boxes_(leaf_boxes) {}

    /// Negations are pushed down to the leaves (De Morgan) and nested gates of one kind are merged on the way.
    std::vector<Draft> draft(std::span<const std::uint32_t> nodes) {
        drafts_.push_back({Draft::Op::any});
        std::vector<Pending> pending;
        for (auto it = nodes.rbegin(); it != nodes.rend(); ++it) pending.push_back({*it, false, 0});
        while (!pending.empty()) {
            const Pending p = pending.back();
            pending.pop_back();
            expand(p, pending);
        }
        return std::move(drafts_);
    }

private:
    void expand(const Pending& p, std::vector<Pending>& pending) {
        const SolidNode& node = tree_.nodes[p.node];
        if (node.op == SolidOp::leaf) {
            Draft leaf{Draft::Op::leaf, p.negated, node.first};
            leaf.bounds = p.negated ? Box3d::everything() : leaf_boxes_[node.first];
            add(leaf, p.parent);
            return;
        }
        // A subtraction is an intersection with complements; a childless intersection or subtraction is empty.
        const bool empty = node.count == 0;
        const bool all = empty ? p.negated : (node.op != SolidOp::unite) != p.negated;
        std::uint32_t under = p.parent;
        const auto op = all ? Draft::Op::all : Draft::Op::any;
        if (empty || drafts_[p.parent].op != op) under = add({op}, p.parent);
        for (std::uint32_t i = node.count; i-- > 0;)
            pending.push_back(
                {tree_.children[node.first + i], p.negated != (node.op == SolidOp::subtract && i > 0), under});
    }
    std::uint32_t add(Draft draft, std::uint32_t parent) {
        drafts_.push_back(std::move(draft));
        const auto index = static_cast<std::uint32_t>(drafts_.size() - 1);
        drafts_[parent].children.push_back(index);
        return index;
    }

    const SolidTree& tree_;
    const std::vector<Box3d>& leaf_boxes_;
    std::vector<Draft> drafts_;  ///< parents before children
};

/// Bounds from the leaves up: an AND is within each of its children, an OR within all of them together.
void bound(std::vector<Draft>& drafts) {
    for (auto it = drafts.rbegin(); it != drafts.rend(); ++it) {
        Draft& d = *it;
        if (d.op == Draft::Op::all) {
            d.bounds = Box3d::everything();
            for (const std::uint32_t c : d.children) d.bounds = d.bounds.intersection(drafts[c].bounds);
        } else if (d.op == Draft::Op::any) {
            d.bounds = Box3d{};
            for (const std::uint32_t c : d.children)
                if (!drafts[c].bounds.empty()) d.bounds.include(drafts[c].bounds);
        }
        d.never = d.bounds.empty();
    }
}

/// Where each draft matters, from the root down: outside of any ancestor's bounds that ancestor is false whatever it
/// says.
void confine(std::vector<Draft>& drafts, const std::vector<Box3d>& leaf_boxes) {
    drafts[0].matters = drafts[0].bounds;
    for (Draft& parent : drafts) {
        for (const std::uint32_t c : parent.children) {
            Draft& child = drafts[c];
            child.matters = parent.matters.intersection(child.bounds);
            if (child.op == Draft::Op::leaf) {
                child.matters = parent.matters.intersection(leaf_boxes[child.leaf]);
                (child.negated ? child.always : child.never) |= child.matters.empty();
            } else {
                child.never |= child.matters.empty();
            }
        }
    }
}

/// Constants from the leaves up, so that what is left can change something.
void fold(std::vector<Draft>& drafts) {
    for (auto it = drafts.rbegin(); it != drafts.rend(); ++it) {
        Draft& d = *it;
        if (d.op == Draft::Op::leaf) continue;
        const bool all = d.op == Draft::Op::all;
        const auto decides = [&](std::uint32_t c) { return all ? drafts[c].never : drafts[c].always; };
        const auto idle = [&](std::uint32_t c) { return all ? drafts[c].always : drafts[c].never; };
        const bool decided = std::any_of(d.children.begin(), d.children.end(), decides);
        std::erase_if(d.children, idle);
        if (decided) d.children.clear();
        if (d.never)
            d.children.clear(), d.always = false;
        else if (d.children.empty())
            (all != decided ? d.always : d.never) = true;
    }
}

/// The draft that stands for the root: gates of one gate are passed over.
std::uint32_t root_of(const std::vector<Draft>& drafts) {
    std::uint32_t root = 0;
    while (drafts[root].children.size() == 1 && drafts[drafts[root].children[0]].op != Draft::Op::leaf)
        root = drafts[root].children[0];
    return root;
}

/// The drafts below root as gates, children first, and inputs, in the order of the file.
void number(const std::vector<Draft>& drafts, std::uint32_t root, Gates& out) {
    std::vector<bool> kept(drafts.size(), false);
    kept[root] = true;
    for (std::size_t i = root; i < drafts.size(); ++i)
        if (kept[i])
            for (const std::uint32_t c : drafts[i].children) kept[c] = true;
    std::vector<std::uint32_t> gate_of(drafts.size(), Gates::none), parent_of(drafts.size(), Gates::none);
    for (std::size_t i = drafts.size(); i-- > root;) {
        if (!kept[i] || drafts[i].op == Draft::Op::leaf) continue;
        gate_of[i] = static_cast<std::uint32_t>(out.gates.size());
        for (const std::uint32_t c : drafts[i].children) parent_of[c] = gate_of[i];
        const auto n = static_cast<std::int32_t>(drafts[i].children.size());
        out.gates.push_back({Gates::none, drafts[i].op == Draft::Op::all ? n : 1, 0});
    }
    for (std::size_t i = root; i < drafts.size(); ++i) {
        if (!kept[i]) continue;
        if (drafts[i].op != Draft::Op::leaf) {
            out.gates[gate_of[i]].parent = parent_of[i];
            continue;
        }
        out.leaves.push_back(drafts[i].leaf);
        out.inputs.push_back({parent_of[i] & Gates::none, drafts[i].negated});
        out.boxes.push_back(drafts[i].matters);
        out.gates[parent_of[i]].at_rest += drafts[i].negated;
    }
    for (const Gate& gate : out.gates)  // children stand first, so their counts are final when they are read
        if (gate.parent != Gates::none && gate.at_rest >= gate.threshold) ++out.gates[gate.parent].at_rest;
}

/// The first positive leaf that feeds nothing but ANDs (or gates of one input) up to the root.
std::uint32_t required_input(const Gates& g) {
    std::vector<std::int32_t> fan_in(g.gates.size(), 0);
    for (const Input& in : g.inputs) ++fan_in[in.gate];
    for (const Gate& gate : g.gates)
        if (gate.parent != Gates::none) ++fan_in[gate.parent];
    std::vector<bool> needed(g.gates.size());
    for (std::size_t i = g.gates.size(); i-- > 0;)
        needed[i] =
            g.gates[i].threshold == fan_in[i] && (g.gates[i].parent == Gates::none || needed[g.gates[i].parent]);
    for (std::uint32_t i = 0; i < g.inputs.size(); ++i)
        if (!g.inputs[i].negated && needed[g.inputs[i].gate]) return i;
    return Gates::none;
}

}  // namespace

Gates make_gates(const SolidTree& tree, std::span<const std::uint32_t> nodes, const std::vector<Box3d>& leaf_boxes) {
    std::vector<Draft> drafts = Drafter(tree, leaf_boxes).draft(nodes);
    bound(drafts);
    confine(drafts, leaf_boxes);
    fold(drafts);
    Gates out;
    const std::uint32_t root = root_of(drafts);
    if (drafts[root].never || drafts[root].children.empty()) return out;
    out.bounds = drafts[root].bounds;
    number(drafts, root, out);
    out.required = required_input(out);
    return out;
}

}  // namespace cardioid::csg

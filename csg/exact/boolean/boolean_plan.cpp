#include "csg/exact/boolean/boolean_plan.hpp"

#include <algorithm>
#include <map>

#include "csg/exact/evaluate_mesh.hpp"

namespace cardioid::csg {

namespace {

using Parts = std::vector<std::uint32_t>;

/// Adds the fewer to the more: a chain of any depth costs n log n.
void join(Parts& to, Parts more) {
    if (more.size() > to.size()) std::swap(more, to);
    to.insert(to.end(), more.begin(), more.end());
}

class Planner {
public:
    explicit Planner(const SolidTree& tree) : tree_(tree) {}

    std::vector<PlannedBoolean> plan(std::uint32_t node) {
        const std::vector<std::uint32_t> nodes = nodes_below(tree_, node);
        for (const std::uint32_t index : nodes) {
            const SolidNode& at = tree_.nodes[index];
            stands_for_[index] = is_wrapper(at) ? child(at, 0) : index;
            if (at.op == SolidOp::leaf || is_wrapper(at)) continue;
            for (std::uint32_t c = 0; c < at.count; ++c) ++uses_[child(at, c)];
        }
        for (const std::uint32_t index : nodes)
            if (stands_for_[index] == index) step_of_[index] = add(tree_.nodes[index]);
        return needed(step_of_[stands_for_[node]]);
    }

private:
    static bool is_wrapper(const SolidNode& node) { return node.op != SolidOp::leaf && node.count == 1; }

    [[nodiscard]] std::uint32_t child(const SolidNode& node, std::uint32_t c) const {
        return stands_for_.at(tree_.children[node.first + c]);
    }

    std::uint32_t add(const SolidNode& node) {
        if (node.op == SolidOp::leaf) return keep({SolidOp::leaf, node.first, {}, 0});
        Parts parts;
        if (node.op == SolidOp::subtract && node.count > 1)
            parts = subtraction(node);
        else
            for (std::uint32_t c = 0; c < node.count; ++c) join(parts, parts_of(child(node, c), node.op));
        return keep({node.op, 0, std::move(parts), 0});
    }

    /// (a - b) - c is a - (b + c).
    Parts subtraction(const SolidNode& node) {
        Parts first = parts_of(child(node, 0), SolidOp::subtract), taken(first.begin() + 1, first.end());
        for (std::uint32_t c = 1; c < node.count; ++c) join(taken, parts_of(child(node, c), SolidOp::unite));
        first.resize(1);
        first.insert(first.end(), taken.begin(), taken.end());
        return first;
    }

    /// What a node does with `op`, taken from its step where nothing else needs that; else its step.
    Parts parts_of(std::uint32_t node, SolidOp op) {
        const std::uint32_t index = step_of_.at(node);
        PlannedBoolean& step = steps_[index];
        if (step.op != op || uses_[node] > 1 || step.parts.empty()) return {index};
        return std::move(step.parts);
    }

    std::uint32_t keep(PlannedBoolean step) {
        steps_.push_back(std::move(step));
        return static_cast<std::uint32_t>(steps_.size() - 1);
    }

    /// The steps that `last` needs, numbered anew, with their heights.
    std::vector<PlannedBoolean> needed(std::uint32_t last) {
        std::vector<bool> is_needed(steps_.size());
        is_needed[last] = true;
        for (std::size_t i = last + 1; i-- > 0;)
            if (is_needed[i])
                for (const std::uint32_t part : steps_[i].parts) is_needed[part] = true;
        std::vector<PlannedBoolean> out;
        std::vector<std::uint32_t> number(steps_.size());
        for (std::size_t i = 0; i <= last; ++i) {
            if (!is_needed[i]) continue;
            PlannedBoolean step = std::move(steps_[i]);
            for (std::uint32_t& part : step.parts) {
                part = number[part];
                step.height = std::max(step.height, out[part].height + 1);
            }
            number[i] = static_cast<std::uint32_t>(out.size());
            out.push_back(std::move(step));
        }
        return out;
    }

    const SolidTree& tree_;
    std::vector<PlannedBoolean> steps_;
    std::map<std::uint32_t, std::uint32_t> stands_for_, step_of_, uses_;
};

}  // namespace

std::vector<PlannedBoolean> plan_booleans(const SolidTree& tree, std::uint32_t node) {
    return Planner(tree).plan(node);
}

}  // namespace cardioid::csg

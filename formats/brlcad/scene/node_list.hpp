#pragma once
#include <optional>
#include <vector>

#include "formats/brlcad/database.hpp"
#include "rt_core/scene/solid.hpp"

namespace cardioid::formats::brlcad {

/// A part of a boolean tree that is still growing: chains of one operation become one node of many children. Nothing
/// is the empty set.
class NodeList {
public:
    explicit NodeList(std::optional<std::uint32_t> node) {
        if (node) nodes_.push_back(*node);
    }
    /// This one op the other one, in place of this one.
    void join(Step::Op op, const NodeList& right, SolidTree& tree);
    /// Everything but this one.
    void complement(SolidTree& tree);
    /// The node; nothing where it is empty.
    std::optional<std::uint32_t> node(SolidTree& tree) const;

private:
    std::vector<std::uint32_t> nodes_;
    SolidOp op_ = SolidOp::unite;  ///< over nodes_ where they are several
};

}  // namespace cardioid::formats::brlcad

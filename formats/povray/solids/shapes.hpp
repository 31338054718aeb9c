#pragma once
#include <string>

#include "rt_core/scene/solid.hpp"

namespace cardioid::formats::povray {

/// Which sides of a leaf are to be moved outwards, so that they coincide with no others.
struct Growth {
    double by = 0;        ///< POV-Ray's units; 0: none
    Vec2d x, y, z;        ///< shares of `by` by which the ends along the local axes are moved
    bool around = false;  ///< what is round, or the sides of a prism, too
    [[nodiscard]] bool none() const { return by == 0; }
};

/// A leaf as a shape of POV-Ray without its closing brace, such as `sphere { <0, 0, 0>, 1`. scale: POV-Ray's units to
/// one of ours.
std::string shape(const Leaf& leaf, const SolidTree& solids, double scale, const Growth& growth);

/// The leaf with its sides moved outwards, as nearly as its kind allows.
Leaf grown(const Leaf& leaf, const SolidTree& solids, double scale, const Growth& growth);

}  // namespace cardioid::formats::povray

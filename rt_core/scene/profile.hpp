#pragma once
#include <vector>

#include "rt_core/math/vec.hpp"

namespace cardioid {

/// A plane figure: closed contours, inside by the even-odd rule. Outer contours run counter-clockwise, holes clockwise.
struct Profile {
    std::vector<std::vector<Vec2d>> contours;
    [[nodiscard]] bool empty() const { return contours.empty(); }
};

}  // namespace cardioid

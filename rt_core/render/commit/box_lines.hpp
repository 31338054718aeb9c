#pragma once
#include <array>

#include "rt_core/api/surface.hpp"

namespace cardioid {

/// Oriented lines, all that meet a box with the same chance. A box of surface S is met by lines of measure pi S
/// (Santalo 1976, chapter 14).
class BoxLines {
public:
    /// The box must be bounded.
    explicit BoxLines(const Box3d& box);
    /// The line of u in [0,1)^4; it begins a little outside the box and ends outside it.
    [[nodiscard]] Ray line(const std::array<double, 4>& u) const noexcept;
    /// pi S, scene units^2 sr.
    [[nodiscard]] double measure() const noexcept;

private:
    Box3d box_;
    std::array<double, 3> end_;  ///< areas of the faces across x, y, z, summed up
};

}  // namespace cardioid

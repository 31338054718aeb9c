#pragma once
#include <array>

#include "rt_core/api/math.hpp"
#include "rt_core/api/solid_angle_rectangle.hpp"

namespace cardioid {

/// A box as seen from a point outside it: directions that meet it, drawn evenly over its solid angle, or, from afar,
/// over the area of the faces in sight, each of which has its share of the directions.
class SeenBox {
public:
    /// No face is in sight from inside the box.
    SeenBox(const Box3d& box, Vec3d from) noexcept;

    [[nodiscard]] bool in_sight() const noexcept { return total_ > 0; }
    struct Direction {
        Vec3d d;  ///< unit
        double pdf;
    };
    /// Where the box is in sight.
    [[nodiscard]] Direction sample(Vec2 u) const noexcept;
    /// Density of the unit direction d over solid angle [1/sr]; 0 where it passes by.
    [[nodiscard]] double pdf(Vec3d d) const noexcept;

private:
    struct Face {
        int axis;
        double distance;  ///< to its plane, above 0
        double area;
        double share;  ///< of the directions: its solid angle, or nearly so
    };
    [[nodiscard]] SolidAngleRectangle seen(const Face& face) const noexcept;
    [[nodiscard]] double across(const Face& face) const noexcept;

    Vec3d lo_, hi_;  ///< from the point
    std::array<Face, 3> faces_;
    int count_ = 0;
    bool near_ = false;  ///< shares are solid angles, and directions within a face are even over its own
    double total_ = 0;
};

}  // namespace cardioid

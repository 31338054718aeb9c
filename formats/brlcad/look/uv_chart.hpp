#pragma once
#include <span>
#include <vector>

#include "rt_core/math/affine.hpp"

namespace cardioid::formats::brlcad {

/// Surface coordinates of BRL-CAD's primitives, 0 to 1, as the `ft_uv` of each gives them to shaders.
class UvChart {
public:
    /// Kinds as they stand in a chart's numbers.
    enum class Kind {
        none,   ///< u = v = 0
        ball,   ///< ell: azimuth and elevation; 12 numbers: rows of world -> unit ball
        tube,   ///< tgc: azimuth and height; 14 numbers: rows of world -> unit cylinder, C / A and D / B
        ring,   ///< tor: azimuth and angle around the tube; 12 numbers: rows of world -> ring of radius 1
        plane,  ///< half: there and back every ten metres; 9 numbers: origin and two unit vectors
        faces   ///< arb: 12 numbers a face: normal, origin, and the vectors that u and 1 - v are measured along
    };
    UvChart() = default;
    /// Kind and its numbers; none where they are not as many as it needs.
    explicit UvChart(std::span<const double> numbers);

    /// At the world point p, with the surface's normal there.
    [[nodiscard]] Vec2d at(Vec3d p, Vec3 normal) const noexcept;

private:
    struct Face {
        Vec3d normal, origin, u, v;
    };
    [[nodiscard]] Vec2d on_tube(Vec3d q) const noexcept;
    [[nodiscard]] Vec2d on_faces(Vec3d p, Vec3d normal) const noexcept;

    Kind kind_ = Kind::none;
    Affine to_local_;
    double c_ = 1, d_ = 1;
    std::vector<Face> faces_;
};

}  // namespace cardioid::formats::brlcad

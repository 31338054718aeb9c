#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "rt_core/api/math.hpp"

namespace cardioid {

/// A rectangle as seen from a point, sampled uniformly over its solid angle (Urena, Fajardo, King 2013, "An
/// Area-Preserving Parametrization for Spherical Rectangles").
class SolidAngleRectangle {
public:
    /// corner: from the point; x, y: unit, orthogonal edges' directions; width, height: their lengths.
    SolidAngleRectangle(Vec3d corner, Vec3d x, Vec3d y, double width, double height) noexcept
        : x_(x), y_(y), z_(cross(x, y)), x0_(dot(corner, x)), y0_(dot(corner, y)), z0_(dot(corner, z_)) {
        if (z0_ > 0) z0_ = -z0_, z_ = -z_;
        x1_ = x0_ + width, y1_ = y0_ + height;
        // Normals of the planes through the point and an edge: (0, -z0, y0) and the like, of unit length.
        const double z2 = z0_ * z0_;
        const double n0 = 1 / std::sqrt(z2 + y0_ * y0_), n1 = 1 / std::sqrt(z2 + x1_ * x1_);
        const double n2 = 1 / std::sqrt(z2 + y1_ * y1_), n3 = 1 / std::sqrt(z2 + x0_ * x0_);
        b0_ = -y0_ * n0, b1_ = y1_ * n2;
        const double b_right = x1_ * n1, b_left = -x0_ * n3;
        const auto angle = [](double cosine) { return std::acos(std::clamp(-cosine, -1.0, 1.0)); };
        const double g0 = angle(b0_ * b_right), g1 = angle(b_right * b1_);
        const double g2 = angle(b1_ * b_left), g3 = angle(b_left * b0_);
        k_ = 2 * std::numbers::pi - g2 - g3;
        solid_angle_ = g0 + g1 - k_;
    }
    /// 0 from the rectangle's own plane, as are rounding errors from far away.
    [[nodiscard]] double solid_angle() const noexcept { return solid_angle_; }
    /// A point of the rectangle, from the point it is seen from.
    [[nodiscard]] Vec3d sample(Vec2d u) const noexcept {
        const double a = u.x * solid_angle_ + k_;
        const double fu = (std::cos(a) * b0_ - b1_) / std::sin(a);
        const double cu = std::clamp(std::copysign(1.0, fu) / std::sqrt(fu * fu + b0_ * b0_), -1.0, 1.0);
        const double xu = std::clamp(-(cu * z0_) / std::max(std::sqrt(1 - cu * cu), 1e-300), x0_, x1_);
        const double d = std::sqrt(xu * xu + z0_ * z0_);
        const double h0 = y0_ / std::sqrt(d * d + y0_ * y0_), h1 = y1_ / std::sqrt(d * d + y1_ * y1_);
        const double hv = h0 + u.y * (h1 - h0);
        const double yv = hv * hv < 1 ? std::clamp(hv * d / std::sqrt(1 - hv * hv), y0_, y1_) : y1_;
        return x_ * xu + y_ * yv + z_ * z0_;
    }

private:
    Vec3d x_, y_, z_;
    double x0_, y0_, z0_, x1_, y1_;
    double b0_, b1_, k_, solid_angle_;
};

}  // namespace cardioid

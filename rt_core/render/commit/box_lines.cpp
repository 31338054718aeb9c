#include "rt_core/render/commit/box_lines.hpp"

#include <numbers>

namespace cardioid {

BoxLines::BoxLines(const Box3d& box) : box_(box) {
    const Vec3d s = box.size();
    end_ = {s.y * s.z, s.y * s.z + s.x * s.z, s.y * s.z + s.x * s.z + s.x * s.y};
}

double BoxLines::measure() const noexcept { return std::numbers::pi * 2 * end_[2]; }

Ray BoxLines::line(const std::array<double, 4>& u) const noexcept {
    // A face across one of the axes, its low or its high one, and a place on it.
    const bool high = u[0] >= 0.5;
    const double area = (high ? 2 * u[0] - 1 : 2 * u[0]) * end_[2];
    const int axis = area < end_[0] ? 0 : area < end_[1] ? 1 : 2;
    const auto a = static_cast<std::size_t>(axis);
    const double before = axis == 0 ? 0 : end_[a - 1];
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const Vec3d size = box_.size();
    Vec3d o;
    o[axis] = high ? box_.hi[axis] : box_.lo[axis];
    o[i] = box_.lo[i] + size[i] * std::min(1.0, (area - before) / (end_[a] - before));
    o[j] = box_.lo[j] + size[j] * u[1];
    // Cosine to the inward normal.
    const double cosine = std::sqrt(1 - u[2]), sine = std::sqrt(u[2]), phi = 2 * std::numbers::pi * u[3];
    Vec3d d;
    d[axis] = high ? -cosine : cosine;
    d[i] = sine * std::cos(phi);
    d[j] = sine * std::sin(phi);
    // A solid that fills the box is met on its faces, not left from them.
    const double length = box_.diagonal();
    return {o - d * (0.01 * length), d, 1.1 * length, {}, {}};
}

}  // namespace cardioid

#include "rt_core/render/commit/seen_box.hpp"

namespace cardioid {

namespace {

/// From farther away than so many diagonals the density over the faces' area hardly differs from an even one, and
/// differences of angles lose their digits.
constexpr double far_away = 2;

/// The other two axes, in turn.
int next(int axis) { return axis == 2 ? 0 : axis + 1; }

}  // namespace

SeenBox::SeenBox(const Box3d& box, Vec3d from) noexcept : lo_(box.lo - from), hi_(box.hi - from) {
    const Vec3d middle = (lo_ + hi_) * 0.5, size = hi_ - lo_;
    near_ = dot(middle, middle) < far_away * far_away * dot(size, size);
    for (int axis = 0; axis < 3; ++axis) {
        const bool below = lo_[axis] > 0;
        if (!below && !(hi_[axis] < 0)) continue;
        const int u = next(axis), v = next(u);
        Face face{axis, below ? lo_[axis] : -hi_[axis], size[u] * size[v], 0};
        if (!(face.area > 0)) continue;
        face.share = near_ ? seen(face).solid_angle() : across(face);
        if (!(face.share > 0)) continue;
        total_ += face.share;
        faces_[static_cast<std::size_t>(count_++)] = face;
    }
}

/// The face's solid angle from afar: area cos / d^2 of its middle.
double SeenBox::across(const Face& face) const noexcept {
    Vec3d middle = (lo_ + hi_) * 0.5;
    middle[face.axis] = face.distance;
    const double d2 = dot(middle, middle);
    return face.area * face.distance / (d2 * std::sqrt(d2));
}

SolidAngleRectangle SeenBox::seen(const Face& face) const noexcept {
    const int u = next(face.axis), v = next(u);
    Vec3d corner = lo_, x, y;
    if (hi_[face.axis] < 0) corner[face.axis] = hi_[face.axis];
    x[u] = 1, y[v] = 1;
    return {corner, x, y, hi_[u] - lo_[u], hi_[v] - lo_[v]};
}

SeenBox::Direction SeenBox::sample(Vec2 numbers) const noexcept {
    double place = numbers.x * total_;
    int i = 0;
    for (; i + 1 < count_ && place >= faces_[static_cast<std::size_t>(i)].share; ++i)
        place -= faces_[static_cast<std::size_t>(i)].share;
    const Face& face = faces_[static_cast<std::size_t>(i)];
    const Vec2d u{std::clamp(place / face.share, 0.0, 1.0), numbers.y};
    if (near_) return {normalize(seen(face).sample(u)), 1 / total_};
    const int a = next(face.axis), b = next(a);
    Vec3d q;
    q[face.axis] = lo_[face.axis] > 0 ? face.distance : -face.distance;
    q[a] = lo_[a] + u.x * (hi_[a] - lo_[a]);
    q[b] = lo_[b] + u.y * (hi_[b] - lo_[b]);
    const double d2 = dot(q, q), distance = std::sqrt(d2);
    return {q / distance, face.share / total_ * d2 * distance / (face.area * face.distance)};
}

double SeenBox::pdf(Vec3d d) const noexcept {
    for (int i = 0; i < count_; ++i) {
        const Face& face = faces_[static_cast<std::size_t>(i)];
        const double towards = lo_[face.axis] > 0 ? d[face.axis] : -d[face.axis];
        if (!(towards > 0)) continue;
        const Vec3d q = d * (face.distance / towards);
        const int a = next(face.axis), b = next(a);
        if (q[a] < lo_[a] || q[a] > hi_[a] || q[b] < lo_[b] || q[b] > hi_[b]) continue;
        if (near_) return 1 / total_;
        return face.share / total_ * dot(q, q) / (face.area * towards);
    }
    return 0;
}

}  // namespace cardioid

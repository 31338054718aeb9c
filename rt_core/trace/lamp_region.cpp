#include "rt_core/trace/lamp_region.hpp"

#include <cmath>

namespace cardioid {

LampRegion::LampRegion(const LampShape& shape)
    : shape_(shape),
      to_local_(shape.to_world.inverse()),
      front_(normalize(Vec3(to_local_.transposed_vector({0, 0, -1})))),
      radius_(shape.size.x * length(shape.to_world.column(0))) {}

Box3d LampRegion::bounds() const noexcept {
    if (shape_.kind == LampShape::Kind::sphere) return Box3d{shape_.to_world.t, shape_.to_world.t}.padded(radius_);
    const bool disc = shape_.kind == LampShape::Kind::disc;
    const double x = disc ? shape_.size.x : shape_.size.x / 2, y = disc ? shape_.size.x : shape_.size.y / 2;
    return shape_.to_world.box({{-x, -y, 0}, {x, y, 0}});
}

bool LampRegion::ball_boundary(const Ray& ray, bool leaving, Hit& hit) const noexcept {
    const Vec3d to_centre = shape_.to_world.t - ray.o;
    const double middle = dot(to_centre, ray.d) / dot(ray.d, ray.d);
    const Vec3d closest = ray.o + ray.d * middle - shape_.to_world.t;
    const double half_square = (radius_ * radius_ - dot(closest, closest)) / dot(ray.d, ray.d);
    if (half_square <= 0) return false;
    const double half = std::sqrt(half_square);
    const bool inside = leaving ? dot(ray.d, Vec3d(ray.from_ng)) < 0 : dot(to_centre, to_centre) < radius_ * radius_;
    if (leaving && !inside) return false;
    const double t = inside ? middle + half : middle - half;
    if (!(t > 0 && t < ray.t_max)) return false;
    hit.t = t;
    hit.ng = normalize(Vec3(closest + ray.d * (t - middle)));
    return true;
}

bool LampRegion::first_boundary(const Ray& ray, std::uint32_t self, Hit& hit) const noexcept {
    const bool leaving = ray.from.region == self;
    if (shape_.kind == LampShape::Kind::sphere) {
        if (!ball_boundary(ray, leaving, hit)) return false;
    } else {
        if (leaving) return false;
        // Most rays end before the plate's plane or look away from it: told without a division.
        const double height = dot(to_local_.row[2], ray.o) + to_local_.t.z, rise = dot(to_local_.row[2], ray.d);
        const double against = rise < 0 ? height : -height;
        if (!(against > 0 && against < ray.t_max * std::abs(rise))) return false;
        const Vec3d o = to_local_.point(ray.o), d = to_local_.vector(ray.d);
        const double t = -height / rise;
        const double x = o.x + t * d.x, y = o.y + t * d.y;
        const bool within = shape_.kind == LampShape::Kind::disc
                                ? x * x + y * y <= shape_.size.x * shape_.size.x
                                : std::abs(x) <= shape_.size.x / 2 && std::abs(y) <= shape_.size.y / 2;
        if (!within) return false;
        hit.t = t;
        hit.ng = front_;
    }
    hit.id.face = 0;
    hit.leaf = 0;
    return true;
}

Sides LampRegion::sides(Vec3d p, Vec3d) const noexcept {
    const Vec3d from_centre = p - shape_.to_world.t;
    const bool inside = shape_.kind == LampShape::Kind::sphere && dot(from_centre, from_centre) < radius_ * radius_;
    return {inside, inside};
}

}  // namespace cardioid

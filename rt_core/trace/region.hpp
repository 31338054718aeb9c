#pragma once
#include <cstdint>

#include "rt_core/api/surface.hpp"

namespace cardioid {

/// Whether the two sides of a point on a surface are inside a solid.
struct Sides {
    bool front = false;  ///< towards +n
    bool back = false;
};

/// A bounded or unbounded solid that the tracer asks for its boundary; one primitive of Embree's user geometry.
/// Rays are exact: everything is in double precision. Any thread may call it.
class Region {
public:
    virtual ~Region() = default;
    /// Box that contains all of it; may be infinite.
    [[nodiscard]] virtual Box3d bounds() const noexcept = 0;
    /// The first boundary with 0 < t < t_max. If ray.from names a face of this region (its index is `self`), or any
    /// face parallel to ray.from_ng passes through ray.o, that one is not met again. `hit.id.region` is left alone.
    /// Returns false where there is none; then `hit` is unchanged.
    [[nodiscard]] virtual bool first_boundary(const Ray& ray, std::uint32_t self, Hit& hit) const noexcept = 0;
    /// Which sides of p, on a surface with unit normal n, are inside.
    [[nodiscard]] virtual Sides sides(Vec3d p, Vec3d n) const noexcept = 0;
    /// Material of the face that leaf `leaf` owns.
    [[nodiscard]] virtual std::uint32_t material(std::uint32_t leaf) const noexcept = 0;
    /// Material that fills the solid just inside p (for its medium).
    [[nodiscard]] virtual std::uint32_t interior_material(Vec3d p) const noexcept = 0;
    [[nodiscard]] virtual std::size_t leaf_count() const noexcept = 0;
    /// Area of the whole boundary where it is known exactly, else 0.
    [[nodiscard]] virtual double area() const noexcept { return 0; }
    /// Whether it is known to be the ball that fits its bounds.
    [[nodiscard]] virtual bool is_ball() const noexcept { return false; }
    [[nodiscard]] virtual std::size_t memory_bytes() const noexcept = 0;
};

}  // namespace cardioid

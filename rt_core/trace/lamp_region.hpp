#pragma once
#include "rt_core/api/light.hpp"
#include "rt_core/trace/region.hpp"

namespace cardioid {

/// The plate or ball of a lamp as the tracer meets it. A plate is one face without thickness, so nothing is inside it.
class LampRegion final : public Region {
public:
    explicit LampRegion(const LampShape& shape);
    [[nodiscard]] Box3d bounds() const noexcept override;
    [[nodiscard]] bool first_boundary(const Ray& ray, std::uint32_t self, Hit& hit) const noexcept override;
    [[nodiscard]] Sides sides(Vec3d p, Vec3d n) const noexcept override;
    [[nodiscard]] std::uint32_t material(std::uint32_t) const noexcept override { return 0; }
    [[nodiscard]] std::uint32_t interior_material(Vec3d) const noexcept override { return 0; }
    [[nodiscard]] std::size_t leaf_count() const noexcept override { return 1; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override { return sizeof(*this); }

private:
    [[nodiscard]] bool ball_boundary(const Ray& ray, bool leaving, Hit& hit) const noexcept;

    LampShape shape_;
    Affine to_local_;
    Vec3 front_;     ///< world normal of a plate's emitting side
    double radius_;  ///< of a ball, scene units
};

}  // namespace cardioid

#pragma once
#include "csg/leaves/area.hpp"
#include "csg/region/tolerances.hpp"
#include "rt_core/trace/region.hpp"

namespace cardioid::csg {

struct Span;

/// A solid of one leaf: what unions of thousands of parts are made of. 192 bytes.
class LeafRegion final : public Region {
public:
    /// What the leaf and the tolerances point to must outlive the region.
    LeafRegion(const SolvedLeaf& leaf, const Box3d& bounds, const Tolerances& tolerances);
    [[nodiscard]] Box3d bounds() const noexcept override;
    [[nodiscard]] bool first_boundary(const Ray& ray, std::uint32_t self, Hit& hit) const noexcept override;
    [[nodiscard]] Sides sides(Vec3d p, Vec3d n) const noexcept override;
    [[nodiscard]] std::uint32_t material(std::uint32_t) const noexcept override { return leaf_.material; }
    [[nodiscard]] std::uint32_t interior_material(Vec3d) const noexcept override { return leaf_.material; }
    [[nodiscard]] std::size_t leaf_count() const noexcept override { return 1; }
    [[nodiscard]] double area() const noexcept override { return leaf_area(leaf_); }
    [[nodiscard]] bool is_ball() const noexcept override { return leaf_.solver == Solver::ball; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override;

private:
    [[nodiscard]] bool first_of(const Event* begin, const Event* end, const Ray& ray, Hit& hit) const noexcept;
    [[nodiscard]] bool first_of(const Span& span, const Ray& ray, Hit& hit) const noexcept;
    /// The events along the ray, in the thread's buffer.
    [[nodiscard]] const EventList& events(const Ray& ray) const noexcept;

    SolvedLeaf leaf_;
    Box3d bounds_;
    const Tolerances* tolerances_;
};

}  // namespace cardioid::csg

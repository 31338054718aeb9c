#pragma once
#include <memory>
#include <vector>

#include "csg/bvh/bvh8.hpp"
#include "csg/leaves/leaf.hpp"
#include "csg/region/gates.hpp"
#include "csg/region/tolerances.hpp"
#include "rt_core/trace/region.hpp"

namespace cardioid::csg {

/// A boundary of a solid along a ray.
struct Boundary {
    double t;
    Vec3d ng;             ///< out of the solid, unit
    std::uint32_t input;  ///< the leaf that owns it, as a number of the region
    bool entering;
};

/// A boolean of leaves, traced without ever being meshed: leaves are visited in the order of the ray by a hierarchy of
/// boxes, their events are swept through the gates, and the sweep stops at the first change of the root.
class SolidRegion final : public Region {
public:
    /// `leaves` and `shapes` are parallel to gates.inputs; shapes may be null.
    SolidRegion(Gates gates, std::vector<SolvedLeaf> leaves, std::vector<std::shared_ptr<const Shape>> shapes,
                const Tolerances& tolerances);

    [[nodiscard]] Box3d bounds() const noexcept override { return gates_.bounds; }
    [[nodiscard]] bool first_boundary(const Ray& ray, std::uint32_t self, Hit& hit) const noexcept override;
    [[nodiscard]] Sides sides(Vec3d p, Vec3d n) const noexcept override;
    [[nodiscard]] std::uint32_t material(std::uint32_t leaf) const noexcept override { return leaves_[leaf].material; }
    [[nodiscard]] std::uint32_t interior_material(Vec3d p) const noexcept override;
    [[nodiscard]] std::size_t leaf_count() const noexcept override { return leaves_.size(); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept override;

    /// Every boundary with 0 < t < ray.t_max, in order.
    void boundaries(const Ray& ray, std::vector<Boundary>& out) const;
    /// Whether p is inside; points on the surface may go either way.
    [[nodiscard]] bool contains(Vec3d p) const noexcept;

    // What the sweep reads.
    [[nodiscard]] const GateTree& gates() const noexcept { return gates_; }
    [[nodiscard]] const std::vector<SolvedLeaf>& leaves() const noexcept { return leaves_; }
    /// Null where all leaves are tried in turn: few of them, or an unbounded solid.
    [[nodiscard]] const Bvh8* bvh() const noexcept { return bvh_.get(); }
    [[nodiscard]] const Tolerances& tolerances() const noexcept { return tolerances_; }

private:
    GateTree gates_;
    std::vector<SolvedLeaf> leaves_;
    std::vector<std::shared_ptr<const Shape>> shapes_;  ///< each once
    std::unique_ptr<const Bvh8> bvh_;
    Tolerances tolerances_;
    bool one_material_;
    bool one_and_;  ///< of convex leaves
};

}  // namespace cardioid::csg

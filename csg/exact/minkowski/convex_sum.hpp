#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

/// A convex solid whose farthest corner in a direction is found without looking at all of them.
class ConvexPart {
public:
    /// The hull of these points; points in one plane are kept as they are.
    explicit ConvexPart(std::vector<Vec3d> points);

    [[nodiscard]] const std::vector<Vec3d>& corners() const { return hull_.vertices; }
    [[nodiscard]] const std::vector<std::array<std::uint32_t, 3>>& faces() const { return hull_.triangles; }
    [[nodiscard]] bool is_flat() const { return hull_.triangles.empty(); }
    /// A vector out of a face, of the length of twice its area.
    [[nodiscard]] Vec3d normal(std::size_t face) const;
    /// The farthest corner along `direction`, found by walking uphill over edges from corner `start`. Not if flat.
    [[nodiscard]] std::uint32_t farthest(Vec3d direction, std::uint32_t start) const;

private:
    TriangleMesh hull_;
    std::vector<std::uint32_t> first_, neighbours_;  ///< of each corner: neighbours_[first_[i]] .. [first_[i + 1]]
};

/// About how many sums of corners convex_sum() forms.
double sum_points(const ConvexPart& a, const ConvexPart& b);

/// The Minkowski sum of two convex solids, exact but for the rounding of coordinates: the hull of sums of corners that
/// are farthest in some direction. Sums are added until no face of the hull has a point of the true sum beyond it, of
/// which the farthest is known (the sum of those of the two), so that nothing can be missing.
TriangleMesh convex_sum(const ConvexPart& a, const ConvexPart& b);

}  // namespace cardioid::csg

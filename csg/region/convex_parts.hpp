#pragma once
#include "csg/region/solid_region.hpp"

namespace cardioid::csg {

/// Whether a tree is one AND of convex leaves and of complements of convex leaves: A, A - B, A * B - C ..., which most
/// solids that people draw are, once a union's members stand alone.
[[nodiscard]] bool is_one_and_of_convex(const GateTree& gates, const std::vector<SolvedLeaf>& leaves);

enum class Answer { none, found, unsure };

/// The first boundary of such a region by the ends of its leaves' intervals, with no list of events: what Sweep says,
/// to the last bit, in half its time. `unsure`, for Sweep to say, where faces lie so close to the boundary, or to the
/// origin of a ray that leaves a surface, that they may be one with it.
[[nodiscard]] Answer first_by_intervals(const SolidRegion& region, const Ray& ray, Boundary& out) noexcept;

}  // namespace cardioid::csg

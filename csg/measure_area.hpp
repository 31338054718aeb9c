#pragma once
#include <cstdint>

#include "rt_core/trace/region.hpp"

namespace cardioid::csg {

/// A surface measured by lines.
struct AreaEstimate {
    double area = 0;         ///< scene units^2
    double sigma = 0;        ///< standard error
    std::int64_t lines = 0;  ///< that were traced
};

/// Area of the region's surface by `lines` random lines, uniform in place and direction within a ball around `box`: a
/// ball of surface S is met by them as often as the region's surface is by mean crossings n, A = S n / 2 (Cauchy and
/// Crofton; Santalo 1976, "Integral Geometry and Geometric Probability"). The same figures for any number of threads.
/// `box` must be bounded.
AreaEstimate measure_area(const Region& region, const Box3d& box, std::int64_t lines, std::uint32_t seed);

}  // namespace cardioid::csg

#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "rt_core/trace/region.hpp"

namespace cardioid::csg {

/// A stretch of a line, by its distances from the line's origin [scene units].
struct Span {
    double begin = 0, end = 0;
};

/// Stretches of the line o + t d, 0 < t < length, that lie inside the region, in order. d has unit length. Any thread
/// may call it.
std::vector<Span> inside_spans(const Region& region, Vec3d o, Vec3d d, double length);

/// A volume measured by lines, and how sure of it we are.
struct VolumeEstimate {
    double volume = 0;       ///< scene units^3; infinite where the box is
    double sigma = 0;        ///< standard error, from neighbouring pairs of lines (an upper estimate)
    std::int64_t lines = 0;  ///< that were traced
    [[nodiscard]] bool bounded() const { return std::isfinite(volume); }
};

/// Volume of what lies inside `region` and within `box`, by grid x grid nearly parallel lines, one at a random place of
/// each cell of a grid. They run along the shortest side of the box, slightly oblique so that no axis-parallel face is
/// met edge on. The same figures for any number of threads. grid >= 2.
VolumeEstimate measure_volume(const Region& region, const Box3d& box, int grid, std::uint32_t seed);

/// What two solids have in common.
struct Overlap {
    double volume = 0;  ///< scene units^3, roughly
    double depth = 0;   ///< the longest stretch that was found inside both, scene units
    Vec3d where;        ///< its middle
    [[nodiscard]] bool found() const { return volume > 0; }
};

/// Where the insides of a and b overlap within `box`, by grid x grid lines along each axis. Stretches shorter than
/// `least` are no overlap: faces that are meant to touch, or curved walls that touch along a line.
Overlap measure_overlap(const Region& a, const Region& b, const Box3d& box, int grid, double least);

}  // namespace cardioid::csg

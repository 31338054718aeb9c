#pragma once
#include <vector>

#include "bench/models.hpp"

#include "rt_core/trace/tracer.hpp"

namespace cardioid::bench {

using Rays = std::vector<Ray>;

/// Through the centres of width x width pixels, row by row.
Rays primary_rays(const View& view, std::uint32_t width);
/// From random points of a ball around the box to random points of the box.
Rays random_rays(const Box3d& bounds, std::uint32_t count);
/// From random points of the box in random directions: many start inside of solids.
Rays inside_rays(const Box3d& bounds, std::uint32_t count);
/// One diffuse bounce of each ray that hits something, `count` at most.
Rays bounced_rays(const Tracer& tracer, const Rays& rays, std::uint32_t count);

}  // namespace cardioid::bench

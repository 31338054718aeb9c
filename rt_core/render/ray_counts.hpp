#pragma once
#include <cstdint>

namespace cardioid {

/// Rays that this thread has traced for the renderer.
struct RayCounts {
    std::uint64_t camera = 0, shadow = 0, specular = 0;
    std::uint64_t bounce = 0;  ///< of paths, by lobes of any kind
};

/// Counters of the calling thread; whoever wants the count of a piece of work takes the difference.
inline constinit thread_local RayCounts ray_counts;

}  // namespace cardioid

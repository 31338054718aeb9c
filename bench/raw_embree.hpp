#pragma once
#include <vector>

#include "bench/rays.hpp"

#include "rt_core/scene/solid.hpp"
#include "rt_core/trace/embree.hpp"

namespace cardioid::bench {

/// A mesh in Embree and nothing around it: the yardstick of the same run.
class RawEmbree {
public:
    enum class Flags { plain, robust };
    RawEmbree(const TriangleMesh& mesh, Flags flags);
    ~RawEmbree();
    RawEmbree(const RawEmbree&) = delete;
    RawEmbree& operator=(const RawEmbree&) = delete;

    /// rtcIntersect1 for every ray; how many hit. Rays start lifted off their face as the tracer's do.
    [[nodiscard]] std::size_t trace(const std::vector<RTCRay>& rays) const;
    /// rtcOccluded1.
    [[nodiscard]] std::size_t trace_occlusion(const std::vector<RTCRay>& rays) const;
    /// All that Embree holds: its hierarchy and its own copies of vertices and indices.
    [[nodiscard]] std::size_t memory_bytes() const { return static_cast<std::size_t>(bytes_); }

private:
    std::ptrdiff_t bytes_ = 0;
    RTCDevice device_;
    RTCScene scene_;
};

/// `lift`: share of the largest coordinate by which rays that leave a surface start above it.
std::vector<RTCRay> raw_rays(const Rays& rays, double lift);

}  // namespace cardioid::bench

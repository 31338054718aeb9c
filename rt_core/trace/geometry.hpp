#pragma once
#include <memory>
#include <vector>

#include "rt_core/scene/solid.hpp"
#include "rt_core/trace/region.hpp"

namespace cardioid {

/// A triangle mesh that is no part of a boolean; Embree traces it itself.
struct TriangleSurface {
    std::shared_ptr<const TriangleMesh> mesh;
    Affine to_world;
    std::uint32_t material = 0;
};

/// A scene's solids, ready to be traced. Ids of hits count regions first, then surfaces, then lamps.
struct Geometry {
    std::vector<std::unique_ptr<Region>> regions;
    std::vector<TriangleSurface> surfaces;
    std::vector<std::shared_ptr<const void>> shared;  ///< what regions point to
};

/// Box around all that is bounded; a solid without end (a ground) does not count.
Box3d bounded_box(const Geometry& geometry);

}  // namespace cardioid

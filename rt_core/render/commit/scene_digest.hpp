#pragma once
#include <cstddef>
#include <cstdint>

#include "rt_core/scene/scene.hpp"

namespace cardioid {

/// A hash of geometry, materials and lights: what a photon map depends on. Film, cameras and names of files are left
/// out. The same on every machine of the same byte order.
std::uint64_t scene_hash(const Scene& scene);

/// Triangles of meshes and faces of solids: box 6, ball 1, cone 2 and one a cap, prism 2 and one an edge ...
std::size_t face_count(const SolidTree& solids);

}  // namespace cardioid

#pragma once
#include <vector>

#include "rt_core/scene/scene.hpp"
#include "rt_core/trace/geometry.hpp"

namespace cardioid::csg {

/// Scene solids as regions (booleans and quadrics) and surfaces (meshes that need no boolean).
/// transparent[m]: light enters material m. Throws Error(limit) where memory runs out.
Geometry compile(const Scene& scene, const std::vector<bool>& transparent);

/// The whole model as one region, its union regularised: for volumes, membership and tests. Null where it is empty.
std::unique_ptr<Region> compile_whole(const SolidTree& solids, bool six_digits);

}  // namespace cardioid::csg

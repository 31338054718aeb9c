#pragma once
#include <string>

#include "rt_core/api/format.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats::openscad {

/// A scene as `.csg`: every leaf with its material and its whole transform, solids as OpenSCAD's own calls where it has
/// them. Reading it gives the same scene: the same leaves, trees, materials, lights and cameras to the last bit.
std::string write_scene(const Scene& scene, const WriteOptions& options);

}  // namespace cardioid::formats::openscad

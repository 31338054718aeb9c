#pragma once
#include <string>

#include "rt_core/api/format.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats::povray {

/// The scene as a file for POV-Ray 3.7 that gives the same picture: radiance as it is, lengths times a power of ten
/// that keeps POV-Ray's fixed tolerances harmless. What POV-Ray cannot say stands in its head and in options.notes.
/// Formulas: docs/povray.md.
std::string write_scene(const Scene& scene, const WriteOptions& options);

}  // namespace cardioid::formats::povray

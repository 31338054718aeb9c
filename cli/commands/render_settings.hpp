#pragma once
#include "cli/options/render_options.hpp"
#include "rt_core/render/renderer.hpp"

namespace cardioid::cli {

/// What is drawn: the command line first, then the scene's film() and camera(), then the defaults. `model` is the box
/// of the model without lamps and ground, for the fitted camera. Throws Error(usage, limit).
RenderSettings render_settings(const RenderOptions& options, const Scene& scene, const Box3d& model,
                               const LightingModule& lighting);

/// Width and height alone. Throws Error(limit) where the picture would not fit into memory.
std::array<int, 2> picture_size(const RenderOptions& options, const Scene& scene);

}  // namespace cardioid::cli

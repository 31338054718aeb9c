#pragma once
#include <span>
#include <vector>

#include "rt_core/math/rgb.hpp"

namespace cardioid {

/// How different two pictures look to somebody who flips between them, pixel by pixel, from 0 to 1: LDR-FLIP
/// (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild 2020, "FLIP: A Difference Evaluator for
/// Alternating Images"). Linear light; what is outside [0, 1] is cut off, as a display does. pixels_per_degree: 67 is a
/// 4K monitor of 0.7 m seen from 0.7 m, the paper's own. Both pictures have width * height pixels.
std::vector<float> flip(std::span<const Rgb> reference, std::span<const Rgb> test, int width,
                        double pixels_per_degree = 67);

}  // namespace cardioid

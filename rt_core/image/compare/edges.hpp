#pragma once
#include <vector>

#include "rt_core/image/compare/picture.hpp"

namespace cardioid {

/// For each pixel whether one of its eight neighbours, or itself, shows another solid, another side of it, or another
/// depth than a flat or gently bent surface would. Empty where the picture has no layer region, normal or depth.
std::vector<bool> find_edges(const Picture& picture);

}  // namespace cardioid

#pragma once
#include <vector>

#include "formats/brlcad/scene/regions.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats::brlcad {

/// The surface of a look as `rt` shades it, for the lighting "rt".
MaterialSettings rt_material(const RegionLook& look);

/// Gives the lights their places and weights, and takes out what rt takes out of the picture.
void finish_rt(Scene& scene, std::vector<Region>& regions);

}  // namespace cardioid::formats::brlcad

#pragma once
#include <string>
#include <vector>

#include "formats/brlcad/scene/regions.hpp"
#include "formats/brlcad/scene/shader_text.hpp"
#include "rt_core/math/rgb.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats::brlcad {

/// The colour of a look as it is written, 0 to 1 as a display has it.
Rgb display_colour(const RegionLook& look);
/// The same as a reflectance: linear.
Rgb reflectance(const RegionLook& look);

/// Of the bounded parts of a region's solid, not of what is cut from them, as rt bounds a region.
Box3d box_of(const SolidTree& tree, std::uint32_t node);

bool is_light(const RegionLook& look);
/// Of a lamp as its shader says, against others; 0 and more.
double intensity(const RegionLook& look);

/// A physical material that looks as BRL-CAD's shader is meant to; notes get what it cannot say. docs/brlcad.md has the
/// table.
MaterialSettings physical_material(const RegionLook& look, std::vector<std::string>& notes);

/// Gives what is known only once all regions are: the size of checkers and of coloured glass, the radiance of lights.
/// Regions that are no solids in the picture (an envmap) are taken out.
void finish_physical(Scene& scene, std::vector<Region>& regions);

}  // namespace cardioid::formats::brlcad

#pragma once
#include <vector>

#include "formats/povray/solids/facts.hpp"
#include "formats/povray/solids/shapes.hpp"

namespace cardioid::formats::povray {

/// How each node's leaf has to be grown so that no side of a subtrahend coincides with a side of another leaf of its
/// solid: POV-Ray leaves open which of the two a ray meets there. by: POV-Ray's units for one cut; the second cut of a
/// nested subtraction grows twice as far, and none of a solid's leaves grows quite as far as its neighbours.
std::vector<Growth> find_growths(const SolidTree& solids, const SolidFacts& facts, double scene_diagonal, double by);

}  // namespace cardioid::formats::povray

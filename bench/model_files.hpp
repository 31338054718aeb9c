#pragma once
#include <string>

#include "bench/models.hpp"

namespace cardioid::bench {

/// The model with a camera and a lamp without shadow at the eye, as a scene of ours. Only boxes, balls and cones.
std::string as_csg(const Model& model);
/// The same for POV-Ray 3.7, in the form that it renders quickest: balls and axis-parallel boxes as themselves, and
/// a chain of differences as one difference.
std::string as_pov(const Model& model);

}  // namespace cardioid::bench

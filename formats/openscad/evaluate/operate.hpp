#pragma once
#include "formats/openscad/evaluate/state.hpp"

namespace cardioid::formats::openscad {

/// What the children of an operation must be; unknown: what the first of them is.
Dimension operand_dimension(Node node);

/// hull, minkowski, resize, projection, offset, fill: replaces the results since the frame's mark, which stand in the
/// frame's own space, by what the call makes of them, placed as `outer` says. Throws Error(bad_input) for solids
/// without an end and meshes that enclose nothing, Error(limit) where too much would be made.
void operate(const Frame& frame, const State& outer, const Arguments& arguments, Results& results,
             ShapeContext& context);

}  // namespace cardioid::formats::openscad

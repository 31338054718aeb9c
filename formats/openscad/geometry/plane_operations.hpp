#pragma once
#include "formats/openscad/geometry/plane.hpp"

namespace cardioid::formats::openscad {

/// hull, minkowski, resize, offset or fill of plane figures; nothing where nothing is left.
std::optional<Plane> operate_on_planes(Node node, std::vector<Plane> parts, const Arguments& arguments,
                                       ShapeContext& context);

/// The scale that resize(newsize, auto) gives what has this size; dimensions: 2 or 3 that it reckons with.
Vec3d resize_scale(const Arguments& arguments, Vec3d size, int dimensions);

}  // namespace cardioid::formats::openscad

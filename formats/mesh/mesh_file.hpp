#pragma once
#include <string>

#include "rt_core/scene/solid.hpp"

namespace cardioid::formats {

/// Reads STL (ASCII and binary), OBJ or PLY (ASCII and both binary orders) by extension, else by content.
/// Faces with more than three corners are triangulated. Throws Error(io) and Error(bad_input) with file:line or
/// file:byte.
TriangleMesh read_mesh(const std::string& path);

}  // namespace cardioid::formats

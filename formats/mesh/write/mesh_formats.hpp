#pragma once
#include "rt_core/api/format.hpp"

namespace cardioid::formats {

/// Meshes of what a scene encloses, by exact booleans: binary STL and OFF as one solid; OBJ, PLY and 3MF with the
/// material of each part.
extern const Format stl_format, obj_format, ply_format, off_format, three_mf_format;

}  // namespace cardioid::formats

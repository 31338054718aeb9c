#pragma once
#include "formats/mesh/write/scene_meshes.hpp"

namespace cardioid::formats {

/// The parts as a 3MF file, an object a part, in millimetres.
std::string three_mf_archive(const std::vector<MeshPart>& parts);

}  // namespace cardioid::formats

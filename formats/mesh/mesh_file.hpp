#pragma once
#include <string>

#include "rt_core/scene/solid.hpp"

namespace cardioid::formats {

/// The whole file; also a pipe or device. Throws Error(io).
std::string read_bytes(const std::string& path);

/// Reads STL (ASCII and binary), OBJ, PLY (ASCII and both binary orders), OFF, AMF, 3MF, NEF3, glTF or GLB by
/// extension, else by content. Faces with more than three corners are triangulated. The mesh is as the file has it:
/// csg::repair welds it and tells whether it is closed. Memory stays within a few times the file's size, whatever its
/// header says. Throws Error(io), Error(bad_input) with file:line or file:byte (files without a face included),
/// Error(limit) past 2^32 corners.
TriangleMesh read_mesh(const std::string& path);

}  // namespace cardioid::formats

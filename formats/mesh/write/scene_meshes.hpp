#pragma once
#include <string>
#include <vector>

#include "rt_core/scene/scene.hpp"

namespace cardioid::formats {

/// A part of a scene as a mesh: all solids of one material, united.
struct MeshPart {
    std::string material;
    TriangleMesh mesh;  ///< closed
};

/// The solids of a scene as closed meshes by exact booleans, one part a material in the order of the file, or (one) all
/// of them united. A solid belongs to the material of its first leaf. tolerance: how far a mesh may be from a curved
/// surface [scene units]; 0: a share of 1e-4 of the scene's size. Throws Error(bad_input) where there is no solid, or
/// one without an end, or an open mesh.
std::vector<MeshPart> scene_meshes(const Scene& scene, double tolerance, bool one);

}  // namespace cardioid::formats

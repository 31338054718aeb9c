#pragma once
#include <string>
#include <vector>

#include "rt_core/api/progress.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats {

/// A part of a scene as a mesh: all solids of one material, united, or one region of a database.
struct MeshPart {
    std::string name;      ///< of the material or the region
    std::string material;  ///< of the scene
    TriangleMesh mesh;     ///< closed
};

/// How scene_meshes() makes its parts.
struct MeshWish {
    double tolerance = 0;  ///< how far a mesh may be from a curved surface [scene units]; 0: 1e-4 of the scene's size
    bool one = false;      ///< one part in all
    std::vector<std::string>* notes = nullptr;  ///< gets what is left out
    Progress* progress = nullptr;               ///< told how far it is, asked whether to stop: Error(interrupted)
};

/// The solids of a scene as closed meshes by exact booleans, one part a material in the order of the file, or all of
/// them united. A solid belongs to the material of its first leaf. Throws Error(bad_input) where there is no solid, or
/// one without an end, or an open mesh.
///
/// Regions of a database (Scene::names) are closed meshes each of its own, as `g-stl` writes them: they are never
/// united, for they are meant to share no space; those that have no mesh are left out with a note.
std::vector<MeshPart> scene_meshes(const Scene& scene, const MeshWish& wish);

}  // namespace cardioid::formats

#pragma once
#include <string>
#include <vector>

#include "formats/povray/scene/sdl.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats::povray {

/// What a solid of a material is written with.
struct Material {
    std::string texture;         ///< declared name
    std::string interior;        ///< declared name, "" where light does not enter
    bool fills = false;          ///< light enters a medium: faces between solids of one such material are none
    bool transparent = false;    ///< faces inside a union would be seen: it becomes a merge
    bool opaque_shadow = false;  ///< light enters, but our shadow rays do not; POV-Ray's would
    bool photon_target = false;  ///< reflects or bends light, so that it makes caustics
    double field = 0;            ///< of a checker, POV-Ray's units; 0: no checker
};

/// The materials as declarations and, by their index, how to name them. scale: POV-Ray's units to one of ours.
struct Materials {
    std::string declarations;
    std::vector<Material> all;
};
Materials write_materials(const Scene& scene, double scale, Notes& notes);

}  // namespace cardioid::formats::povray

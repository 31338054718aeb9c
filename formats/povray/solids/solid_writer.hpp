#pragma once
#include <string>

#include "formats/povray/scene/materials.hpp"
#include "rt_core/api/format.hpp"

namespace cardioid::formats::povray {

/// What solids are written with besides themselves.
struct SolidSettings {
    const Materials& materials;
    double scale;     ///< POV-Ray's units to one of ours
    double diagonal;  ///< of the scene, our units
    bool photons;     ///< mirrors and glass are targets of photons, which then carry the light through them
};

/// All solids of the scene, each root an object: booleans stay booleans, `merge` where light enters.
std::string write_solids(const Scene& scene, const SolidSettings& settings, Notes& notes);

}  // namespace cardioid::formats::povray

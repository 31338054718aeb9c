#pragma once
#include <string>

#include "formats/povray/scene/sdl.hpp"
#include "rt_core/api/format.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats::povray {

/// How lights are written.
struct LightSpace {
    double scale;                  ///< POV-Ray's units to one of ours
    Vec3d centre;                  ///< of the scene, our units
    double diagonal;               ///< of the scene, our units
    const CameraSettings* camera;  ///< that looks at it; null where there is none
};

/// All lights of the scene, and what is seen of lamps. A lamp becomes K x K points in the middle of equal parts of it,
/// each a spotlight with Lambert's cosine: a single area light of POV-Ray multiplies averages of what is seen and of
/// how bright it is, which is up to 11 % off in half shadows.
std::string write_lights(const Scene& scene, const LightSpace& space, const WriteOptions& options, Notes& notes);

}  // namespace cardioid::formats::povray

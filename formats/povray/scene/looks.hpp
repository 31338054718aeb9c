#pragma once
#include <string>

#include "formats/povray/scene/sdl.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats::povray {

/// A material in POV-Ray's terms. Formulas: POV-Ray 3.7.0.10, as measured; `diffuse 1` with `pigment rgb rho` has the
/// albedo rho.
struct Look {
    Rgb pigment;
    float transmit = 0;    ///< share of light that passes one crossing
    bool diffuse = false;  ///< the pigment reflects, so that emission has to be told by it
    std::string finish;    ///< what stands between the braces, without emission
    std::string interior;  ///< the same; "" where light does not enter
    bool specular = false;
    bool straight_shadows = false;  ///< of what light enters: shadow rays pass unbent here as in POV-Ray
};

/// How a material looks; what is only nearly so is noted. `checker` is not a look of its own. scale: POV-Ray's units to
/// one of ours.
Look look_of(const MaterialSettings& material, double scale, Notes& notes);

}  // namespace cardioid::formats::povray

#pragma once
#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

/// A form as a closed mesh in its own space, its curves in `corners` chords around (at least 12). `ball` is a unit
/// sphere of as many corners, which a superellipsoid is moulded from.
TriangleMesh form_mesh(const Form& form, int corners, const TriangleMesh& ball);

}  // namespace cardioid::csg

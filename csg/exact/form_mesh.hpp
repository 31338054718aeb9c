#pragma once
#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

/// A form as a closed mesh in its own space, its curves in `corners` chords around (at least 12). `ball` is a unit
/// sphere of as many corners, which a superellipsoid is moulded from.
TriangleMesh form_mesh(const Form& form, int corners, const TriangleMesh& ball);

/// A metaball's surface by marching tetrahedra over a grid, `corners` cells or at most 128 a side; its corners lie on
/// the surface, parts smaller than a cell may be missed. Closed.
TriangleMesh blob_mesh(const Form& form, int corners);

}  // namespace cardioid::csg

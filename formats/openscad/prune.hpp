#pragma once
#include "rt_core/scene/solid.hpp"

namespace cardioid::formats::openscad {

/// Takes out what no root needs: the children of booleans that came out empty.
void prune(SolidTree& solids);

/// Numbers the vertices in the order in which the triangles use them, so that a mesh has one spelling.
void renumber(TriangleMesh& mesh);

}  // namespace cardioid::formats::openscad

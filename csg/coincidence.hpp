#pragma once
#include <cstdint>
#include <vector>

#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

/// Two leaves whose faces are near each other and parallel; `a` stands before `b` in the tree.
struct NearFaces {
    enum class Kind : std::uint8_t {
        coincident,  ///< taken for one face: nothing between them is left (regularised booleans)
        thin_solid,  ///< what is left between them is thinner than numbers of six digits tell
        thin_gap     ///< the same of what is missing between them
    };
    Kind kind = Kind::coincident;
    std::uint32_t a = 0, b = 0;  ///< indices into SolidTree::leaves
    Vec3d where;                 ///< the first place that was met, scene units
    double distance = 0;         ///< the largest between the faces along their normal, scene units
    std::int64_t lines = 0;      ///< that met them
};

/// What a search for faces near each other has found.
struct NearFaceReport {
    std::vector<NearFaces> pairs;  ///< each kind and pair once, in order of kind and leaves
    int grid = 0;                  ///< lines along each of two sides of the model's box, for each of the three axes
};

/// Looks for coincident faces and slivers that matter to the model, along grid x grid slightly oblique lines through
/// the model's box along each axis, as `rtcheck` looks for overlaps. The grid is 128, less for very many leaves, never
/// below 16: what is smaller than a cell may be missed. Coincident faces are up to the weld tolerance apart, slivers up
/// to `sliver_share` of the model's size thick. The same result for any number of threads.
NearFaceReport find_near_faces(const SolidTree& tree, bool six_digits, double sliver_share);

}  // namespace cardioid::csg

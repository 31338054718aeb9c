#pragma once
#include <string>
#include <vector>

#include "rt_core/api/registry.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::cli {

/// Something wrong with a scene.
struct Fault {
    std::string kind;  ///< "reader", "open_mesh", "overlap", "material", "unlit", "camera"
    std::string text;  ///< with file:line where there is one
};

struct Findings {
    std::vector<Fault> faults;
    std::vector<std::string> notes;  ///< worth knowing, but no fault
};

/// What the reader warned of: solids of no size, unknown arguments.
void find_reader_faults(const Scene& scene, Findings& findings);
/// Meshes that enclose no volume, with how many edges are open and where the first is.
void find_open_meshes(const Scene& scene, Findings& findings);
/// Pairs of top-level solids whose insides overlap. Found by lines through what their boxes have in common, so that an
/// overlap much smaller than that may be missed.
void find_overlaps(const Scene& scene, Findings& findings);
/// Materials and lights that cannot be made, a scene without light, cameras inside solids.
void find_scene_faults(const Scene& scene, const Registry& registry, Findings& findings);

}  // namespace cardioid::cli

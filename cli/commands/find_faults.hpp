#pragma once
#include <memory>
#include <string>
#include <vector>

#include "rt_core/api/registry.hpp"
#include "rt_core/render/committed_scene.hpp"
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
/// The scene made for rendering, without the studio; null, and a fault, where a material or light cannot be made.
std::unique_ptr<CommittedScene> commit(const Scene& scene, const Registry& registry, Findings& findings);
/// A scene whose lights give none, cameras inside solids.
void find_light_and_camera_faults(const Scene& scene, const CommittedScene& committed, Findings& findings);
/// Pairs of opaque solids whose insides overlap, of different statements at the top of the file or of different
/// materials: solids of one material in one union are meant to be one, and media have priorities. Found by lines
/// through what their boxes have in common, so that an overlap much smaller than that may be missed.
void find_overlaps(const Scene& scene, const CommittedScene& committed, Findings& findings);

}  // namespace cardioid::cli

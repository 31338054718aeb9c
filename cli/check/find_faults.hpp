#pragma once
#include <memory>
#include <string>

#include "cli/check/findings.hpp"
#include "rt_core/api/registry.hpp"
#include "rt_core/render/committed_scene.hpp"

namespace cardioid::cli {

/// Whether solids of the file's top that share space are meant to: where OpenSCAD made it, the top is one union.
/// `text` is the file.
bool is_one_union(const Scene& scene, const std::string& text);

/// What the reader warned of: solids of no size, unknown arguments, files that are not there. Substitutes and
/// approximations are notes.
void find_reader_faults(const Scene& scene, Findings& findings);
/// Colours whose names OpenSCAD did not know: it writes them as [-1, -1, -1].
void find_unknown_colours(const Scene& scene, const std::string& text, Findings& findings);
/// Meshes that enclose no volume, with how many edges are open and where the first is.
void find_open_meshes(const Scene& scene, Findings& findings);

/// The scene made for rendering, without the studio; null, and a fault, where a material or light cannot be made.
std::unique_ptr<CommittedScene> commit(const Scene& scene, const Registry& registry, Findings& findings);
/// A scene whose lights give none, cameras inside solids, cameras whose picture would be black: they look away from the
/// model, or no light gets to what they see.
void find_light_and_camera_faults(const Scene& scene, const CommittedScene& committed, const Registry& registry,
                                  Findings& findings);
/// Pairs of solids whose insides overlap, of different statements at the top of the file or of different materials:
/// solids of one material in one statement are meant to be one, and media have priorities. Regions of a BRL-CAD
/// database may overlap none other, whatever they are made of. Found by 16 x 16 lines along each axis through what the
/// boxes of a pair have in common, so that an overlap much smaller than that may be missed; stretches shorter than 1e-5
/// of the coordinates are faces that touch. one_union: solids may share space, which is a note.
void find_overlaps(const Scene& scene, const CommittedScene& committed, bool one_union, Findings& findings);
/// Faces that coincide (notes: booleans are regularised), and what is left, solid or empty, between faces that ought to
/// (slivers: faults).
void find_near_faces(const Scene& scene, Findings& findings);

}  // namespace cardioid::cli

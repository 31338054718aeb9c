#pragma once
#include <optional>
#include <string>
#include <vector>

#include "rt_core/scene/scene.hpp"

namespace cardioid::cli {

/// Something about a scene that is worth telling.
struct Finding {
    /// "reader", "missing_file", "colour", "open_mesh", "overlap", "coincident", "thin_solid", "thin_gap", "material",
    /// "unlit", "camera", "approximation"
    std::string kind;
    std::string text;                  ///< with file:line where there is one
    std::optional<Vec3d> at;           ///< where, scene units
    std::optional<double> depth;       ///< of an overlap, or what is left between two faces [scene units]
    std::optional<double> volume;      ///< of an overlap, roughly [scene units^3]
    std::vector<std::string> between;  ///< the solids
};

struct Findings {
    std::vector<Finding> faults;
    std::vector<Finding> notes;  ///< no fault: what Cardioid sets right, or what is meant so in such a file
    int face_grid = 0;           ///< lines a side of the search for coincident faces
};

/// What was looked for and how, and what was found, for people. `most` of the faults, and of the notes, are told.
std::string findings_text(const Scene& scene, const Findings& findings, std::size_t most = 100);

/// The same as JSON: all of it.
std::string findings_json(const Scene& scene, const Findings& findings);

}  // namespace cardioid::cli

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string_view>

#include "cli/check/find_faults.hpp"
#include "cli/commands/describe.hpp"
#include "cli/io/scene_input.hpp"
#include "csg/compile.hpp"
#include "csg/shapes/mesh_repair.hpp"

namespace cardioid::cli {
namespace {

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

/// What stands in for something that this machine or this program has not got, or is left over from building the model:
/// nothing is wrong with it.
bool is_substitute(const std::string& warning) {
    constexpr std::array<std::string_view, 6> said{
        "drawn as",    "in its place",           "is left out",
        ": shader \"", "Viewall and autocenter", ": in no combination and left out;"};
    return std::any_of(said.begin(), said.end(), [&](std::string_view part) { return has(warning, part); });
}

std::string kind_of(const std::string& warning) {
    if (has(warning, "no colour \"") || has(warning, "Unable to parse color")) return "colour";
    if (has(warning, "cannot be read") || has(warning, "not found") || has(warning, "Can't open"))
        return "missing_file";
    return "reader";
}

}  // namespace

bool is_one_union(const Scene& scene, const std::string& text) {
    // OpenSCAD prints what a program leaves unsaid; people do not.
    return extension_of(scene.file) == ".scad" || has(text, "center = false") || has(text, "$fn = 0, $fa = 12");
}

void find_reader_faults(const Scene& scene, Findings& findings) {
    for (const std::string& warning : scene.warnings) {
        // Of open meshes find_open_meshes() tells more.
        if (has(warning, "the mesh is not closed")) continue;
        if (is_substitute(warning))
            findings.notes.push_back({.kind = "approximation", .text = warning});
        else
            findings.faults.push_back({.kind = kind_of(warning), .text = warning});
    }
}

void find_unknown_colours(const Scene& scene, const std::string& text, Findings& findings) {
    constexpr std::string_view unknown = "color([-1, -1, -1, 1])";
    std::size_t line = 1, counted = 0;
    for (std::size_t at = text.find(unknown); at != std::string::npos; at = text.find(unknown, at + 1)) {
        line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(counted),
                                                    text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
        counted = at;
        findings.faults.push_back(
            {.kind = "colour",
             .text = fmt::format("{}:{}: found {}: OpenSCAD did not know the colour it was given, and so there is none",
                                 scene.file, line, unknown)});
    }
}

void find_open_meshes(const Scene& scene, Findings& findings) {
    for (const Leaf& leaf : scene.solids.leaves) {
        if (leaf.kind != LeafKind::mesh || scene.solids.meshes[leaf.data]->closed) continue;
        TriangleMesh mesh = *scene.solids.meshes[leaf.data];
        const csg::MeshFaults faults = csg::repair(mesh);
        Finding fault{.kind = "open_mesh",
                      .text = fmt::format("{}:{}: the mesh is not closed: {} open edges", scene.file, leaf.line,
                                          faults.open_edges)};
        if (faults.crowded_edges > 0)
            fault.text += fmt::format(", {} edges of other than two faces", faults.crowded_edges);
        if (!faults.where.empty()) {
            fault.at = leaf.to_world.point(faults.where.front());
            fault.text += ", the first at " + point_text(*fault.at);
        }
        findings.faults.push_back(std::move(fault));
    }
}

std::unique_ptr<CommittedScene> commit(const Scene& scene, const Registry& registry, Findings& findings) {
    try {
        return std::make_unique<CommittedScene>(scene, registry, csg::compile, CommitOptions{.studio = false});
    } catch (const Error& error) {
        if (error.code() != ErrorCode::bad_input) throw;
        findings.faults.push_back({.kind = "material", .text = error.what()});
        return nullptr;
    }
}

}  // namespace cardioid::cli

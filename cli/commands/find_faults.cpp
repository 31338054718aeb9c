#include "cli/commands/find_faults.hpp"

#include <fmt/format.h>

#include "cli/commands/describe.hpp"
#include "csg/compile.hpp"
#include "csg/shapes/mesh_repair.hpp"

namespace cardioid::cli {
namespace {

void find_unlit(const Scene& scene, const CommittedScene& committed, Findings& findings) {
    float power = 0;
    for (const auto& light : committed.lights()) power += max_component(light->power());
    if (power > 0) return;
    if (scene.lights.empty())
        findings.notes.push_back(scene.file + ": there is no light; the studio light will be used");
    else
        findings.faults.push_back({"unlit", scene.file + ": the scene is unlit: its lights have no power"});
}

void find_buried_cameras(const Scene& scene, const CommittedScene& committed, Findings& findings) {
    const auto whole = csg::compile_whole(scene.solids, scene.six_digits);
    if (!whole) return;
    for (const CameraSettings& camera : scene.cameras) {
        const Sides sides = whole->sides(camera.eye, {0, 0, 1});
        if (!sides.front || !sides.back) continue;
        const std::uint32_t material = whole->interior_material(camera.eye);
        if (material < committed.materials().size() && committed.materials()[material].shader->interior()) continue;
        findings.faults.push_back({"camera", fmt::format("{}: camera \"{}\" at {} is inside a solid", scene.file,
                                                         camera.name, point_text(camera.eye))});
    }
}

}  // namespace

void find_reader_faults(const Scene& scene, Findings& findings) {
    // Of open meshes find_open_meshes() tells more.
    for (const std::string& warning : scene.warnings)
        if (warning.find("the mesh is not closed") == std::string::npos) findings.faults.push_back({"reader", warning});
}

void find_open_meshes(const Scene& scene, Findings& findings) {
    for (const Leaf& leaf : scene.solids.leaves) {
        if (leaf.kind != LeafKind::mesh || scene.solids.meshes[leaf.data]->closed) continue;
        TriangleMesh mesh = *scene.solids.meshes[leaf.data];
        const csg::MeshFaults faults = csg::repair(mesh);
        std::string text =
            fmt::format("{}:{}: the mesh is not closed: {} open edges", scene.file, leaf.line, faults.open_edges);
        if (faults.crowded_edges > 0) text += fmt::format(", {} edges of other than two faces", faults.crowded_edges);
        if (!faults.where.empty()) text += ", the first at " + point_text(leaf.to_world.point(faults.where.front()));
        findings.faults.push_back({"open_mesh", text});
    }
}

std::unique_ptr<CommittedScene> commit(const Scene& scene, const Registry& registry, Findings& findings) {
    try {
        return std::make_unique<CommittedScene>(scene, registry, csg::compile, CommitOptions{.studio = false});
    } catch (const Error& error) {
        if (error.code() != ErrorCode::bad_input) throw;
        findings.faults.push_back({"material", error.what()});
        return nullptr;
    }
}

void find_light_and_camera_faults(const Scene& scene, const CommittedScene& committed, Findings& findings) {
    find_unlit(scene, committed, findings);
    find_buried_cameras(scene, committed, findings);
}

}  // namespace cardioid::cli

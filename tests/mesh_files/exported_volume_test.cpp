#include <cmath>
#include <gtest/gtest.h>

#include "csg/compile.hpp"
#include "csg/measure.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "formats/mesh/mesh_file.hpp"
#include "formats/mesh/write/mesh_formats.hpp"
#include "rt_core/api/error.hpp"
#include "rt_core/scene/scene.hpp"
#include "tests/mesh_files/temporary_file.hpp"

// What a mesh file encloses is what rays find in the scene: every format, over models of every kind of solid.
namespace {

using namespace cardioid;
using test::TemporaryFile;

/// Adds leaves with one material.
struct Builder {
    Scene scene;
    Builder() { scene.file = "m.csg", scene.materials = {{"grey", "diffuse", {}}}; }
    std::uint32_t leaf(LeafKind kind, Vec3d at, Vec3d size, double a = 0, double b = 0) {
        return scene.solids.add_leaf({kind, Affine::translation(at) * Affine::scaling(size), a, b, 0, 0});
    }
    std::uint32_t node(SolidOp op, const std::vector<std::uint32_t>& over) { return scene.solids.add_node(op, over); }
};

struct Model {
    std::string name;
    Scene scene;
};

Model drilled_cube() {
    Builder b;
    const auto cube = b.leaf(LeafKind::box, {-5, -5, 0}, {10, 10, 10});
    const auto hole = b.leaf(LeafKind::cone, {0, 0, -1}, {3, 3, 12}, 1, 1);
    const auto sink = b.leaf(LeafKind::cone, {0, 0, 7}, {4, 4, 3}, 0.5, 1);
    b.scene.solids.roots = {b.node(SolidOp::subtract, {cube, hole, sink})};
    return {"a cube with a countersunk hole", b.scene};
}
Model ball_in_box() {
    Builder b;
    const auto ball = b.leaf(LeafKind::sphere, {1, 2, 3}, {4, 5, 6});
    const auto box = b.leaf(LeafKind::box, {-1, -1, -1}, {5, 5, 5});
    b.scene.solids.roots = {b.node(SolidOp::intersect, {ball, box})};
    return {"what an ellipsoid and a box share", b.scene};
}
Model ring_and_balls() {
    Builder b;
    b.scene.solids.roots = {b.leaf(LeafKind::torus, {0, 0, 0}, {1, 1, 1}, 6, 1.5),
                            b.leaf(LeafKind::sphere, {6, 0, 0}, {2.5, 2.5, 2.5}),
                            b.leaf(LeafKind::sphere, {-6, 0, 0}, {2.5, 2.5, 2.5})};
    return {"a ring through two balls", b.scene};
}
Model cavity() {
    Builder b;
    const auto outer = b.leaf(LeafKind::sphere, {0, 0, 0}, {5, 5, 5});
    const auto inner = b.leaf(LeafKind::box, {-2, -2, -2}, {4, 4, 4});
    const auto core = b.leaf(LeafKind::sphere, {0, 0, 0}, {1, 1, 1});
    b.scene.solids.roots = {b.node(SolidOp::unite, {b.node(SolidOp::subtract, {outer, inner}), core})};
    return {"a ball within a cavity", b.scene};
}
Model flush() {
    Builder b;
    const auto block = b.leaf(LeafKind::box, {0, 0, 0}, {10, 10, 10});
    const auto notch = b.leaf(LeafKind::box, {0, 0, 5}, {5, 10, 5});  // three faces coincide
    const auto rest = b.leaf(LeafKind::box, {10, 0, 0}, {10, 10, 10});
    b.scene.solids.roots = {b.node(SolidOp::subtract, {block, notch}), rest};
    return {"blocks with faces in common", b.scene};
}
Model mirrored_half() {
    Builder b;
    const auto ball = b.scene.solids.add_leaf({LeafKind::sphere, Affine::scaling({-3, 3, 3}), 0, 0, 0, 0});
    const auto half = b.scene.solids.add_leaf({LeafKind::half_space, Affine::translation({0, 0, 0.5}), 0, 0, 0, 0});
    b.scene.solids.roots = {b.node(SolidOp::intersect, {ball, half})};
    return {"a mirrored ball cut by a half space", b.scene};
}

std::vector<Model> models() {
    return {drilled_cube(), ball_in_box(), ring_and_balls(), cavity(), flush(), mirrored_half()};
}

csg::VolumeEstimate ray_volume(const SolidTree& solids) {
    const auto whole = csg::compile_whole(solids, false);
    return csg::measure_volume(*whole, whole->bounds(), 128, 0);
}

const std::vector<std::pair<const Format*, std::string>>& formats_out() {
    using namespace formats;
    static const std::vector<std::pair<const Format*, std::string>> all{{&stl_format, "v.stl"},
                                                                        {&off_format, "v.off"},
                                                                        {&obj_format, "v.obj"},
                                                                        {&ply_format, "v.ply"},
                                                                        {&three_mf_format, "v.3mf"}};
    return all;
}

TEST(ExportedMesh, IsClosedOrientedAndHasTheVolumeThatRaysFindInEveryFormat) {
    for (const Model& model : models()) {
        const csg::VolumeEstimate rays = ray_volume(model.scene.solids);
        for (const auto& [format, name] : formats_out()) {
            const TemporaryFile file(name, format->write(model.scene, {.tolerance = 1e-2}));
            TriangleMesh mesh = formats::read_mesh(file.path());
            EXPECT_TRUE(csg::weld(mesh).closed()) << model.name << ", " << name;
            // Chords lie within 1e-2 of surfaces of at most 320 square units.
            EXPECT_NEAR(csg::volume(mesh), rays.volume, 4 * rays.sigma + 1e-2 * 320) << model.name << ", " << name;
            EXPECT_GT(std::abs(csg::volume(mesh) - 1.05 * rays.volume), 4 * rays.sigma) << model.name;
        }
    }
}

TEST(ExportedMesh, HasTheVolumeThatRaysFindInItselfWithinTheirError) {
    for (const Model& model : models()) {
        const TemporaryFile file("v.ply", formats::ply_format.write(model.scene, {.tolerance = 4e-2}));
        TriangleMesh mesh = formats::read_mesh(file.path());
        csg::weld(mesh);
        SolidTree tree;
        const double exact = csg::volume(mesh);
        Leaf leaf{LeafKind::mesh, {}};
        leaf.data = tree.add_mesh(std::move(mesh));
        tree.roots = {tree.add_leaf(leaf)};
        const csg::VolumeEstimate rays = ray_volume(tree);
        EXPECT_NEAR(rays.volume, exact, 4 * rays.sigma + 2e-6 * exact) << model.name;
    }
}

TEST(ExportedMesh, OfADatabaseHasEachRegionByItselfAndNamesThoseThatHaveNone) {
    Builder b;
    b.scene.names = {"/all.g/a.r", "/all.g/ground.r", "/all.g/b.r"};
    b.scene.solids.roots = {b.leaf(LeafKind::box, {0, 0, 0}, {2, 2, 2}), b.leaf(LeafKind::half_space, {}, {1, 1, 1}),
                            b.leaf(LeafKind::box, {1, 1, 1}, {2, 2, 2})};
    std::vector<std::string> notes;
    const std::string obj = formats::obj_format.write(b.scene, {.notes = &notes});
    EXPECT_NE(obj.find("o /all.g/a.r\nusemtl grey\n"), std::string::npos);
    EXPECT_NE(obj.find("o /all.g/b.r\n"), std::string::npos);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0], "m.csg: region /all.g/ground.r is left out: a solid without an end has no mesh");
    const TemporaryFile file("v.stl", formats::stl_format.write(b.scene, {}));
    TriangleMesh mesh = formats::read_mesh(file.path());
    EXPECT_TRUE(csg::weld(mesh).closed());
    EXPECT_NEAR(csg::volume(mesh), 16, 1e-6);
}

}  // namespace

#include <gtest/gtest.h>

#include "csg/shapes/mesh_repair.hpp"
#include "formats/mesh/mesh_file.hpp"
#include "formats/mesh/write/mesh_formats.hpp"
#include "rt_core/api/error.hpp"
#include "rt_core/scene/scene.hpp"
#include "tests/mesh_files/temporary_file.hpp"

// Meshes out: what is written is read again.
namespace {

using namespace cardioid;
using test::TemporaryFile;

/// A cube of 2 without a cube of 1 at its corner, and one of 1 that touches it, of another material.
Scene sample() {
    Scene out;
    out.file = "sample.csg";
    out.materials = {{"grey", "diffuse", {}}, {"red & \"white\"", "diffuse", {}}};
    SolidTree& tree = out.solids;
    const auto cube = [&](Vec3d at, double size, std::uint32_t material) {
        return tree.add_leaf({.kind = LeafKind::box,
                              .to_world = Affine::translation(at) * Affine::scaling({size, size, size}),
                              .material = material});
    };
    const std::uint32_t a = cube({0, 0, 0}, 2, 0), b = cube({1, 1, 1}, 2, 0);
    tree.roots = {tree.add_node(SolidOp::subtract, {a, b}), cube({2, 0, 0}, 1, 1)};
    return out;
}

struct Written {
    bool closed;
    double volume;
};

Written written(const Format& format, const std::string& name) {
    const TemporaryFile file(name, format.write(sample(), {}));
    TriangleMesh mesh = formats::read_mesh(file.path());
    const bool closed = csg::weld(mesh).closed();
    return {closed, csg::volume(mesh)};
}

TEST(MeshesOut, AreClosedAndEncloseWhatTheSceneDoes) {
    using namespace formats;
    for (const auto& [format, name] : {std::pair{&stl_format, "a.stl"},
                                       {&off_format, "a.off"},
                                       {&obj_format, "a.obj"},
                                       {&ply_format, "a.ply"},
                                       {&three_mf_format, "a.3mf"}}) {
        const Written got = written(*format, name);
        EXPECT_TRUE(got.closed) << name;
        EXPECT_NEAR(got.volume, 8, 1e-6) << name;
    }
}

TEST(MeshesOut, NameTheMaterials) {
    const std::string obj = formats::obj_format.write(sample(), {});
    EXPECT_NE(obj.find("usemtl grey\n"), std::string::npos);
    EXPECT_NE(obj.find("usemtl red & \"white\"\n"), std::string::npos);
}

TEST(MeshesOut, OfBallsAreAsFineAsTheToleranceSays) {
    Scene scene;
    scene.materials = {{"grey", "diffuse", {}}};
    scene.solids.roots = {scene.solids.add_leaf({.kind = LeafKind::sphere})};
    double last = 1;
    for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
        const TemporaryFile file("ball.ply", formats::ply_format.write(scene, {.tolerance = tolerance}));
        TriangleMesh mesh = formats::read_mesh(file.path());
        csg::weld(mesh);
        const double missing = 1 - csg::volume(mesh) / (4.0 / 3 * 3.14159265358979);
        EXPECT_LT(missing, 6 * tolerance);
        EXPECT_LT(missing, last);
        last = missing;
    }
}

TEST(MeshesOut, OfWhatHasNoEndOrNothingAreRefused) {
    Scene scene;
    scene.file = "s.csg";
    EXPECT_THROW(formats::stl_format.write(scene, {}), Error);
    scene.solids.roots = {scene.solids.add_leaf({.kind = LeafKind::half_space})};
    EXPECT_THROW(formats::stl_format.write(scene, {}), Error);
}

}  // namespace

#include "formats/mesh/mesh_file.hpp"

#include <gtest/gtest.h>

#include "csg/shapes/mesh_repair.hpp"
#include "tests/mesh_files/sample_meshes.hpp"
#include "tests/mesh_files/temporary_file.hpp"

namespace {

using namespace cardioid;
using test::TemporaryFile;

TriangleMesh read(const std::string& name, const std::string& text) {
    const TemporaryFile file(name, text);
    return formats::read_mesh(file.path());
}

/// Reads, repairs and expects a closed mesh of that volume.
void expect_solid(const std::string& name, const std::string& text, double volume, double tolerance = 1e-12) {
    TriangleMesh mesh = read(name, text);
    const csg::MeshFaults faults = csg::repair(mesh);
    EXPECT_TRUE(faults.closed()) << name;
    EXPECT_FALSE(faults.inside_out) << name;
    EXPECT_NEAR(csg::volume(mesh), volume, tolerance) << name;
}

const TriangleMesh ball = csg::faceted_sphere(3, 20);
const double ball_volume = csg::volume(ball);
const std::string obj_cube =
    "# a cube\nmtllib none.mtl\no cube\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0\nv 0 1 0 0.5 0.5 0.5\nv 0 0 1\nv 1 0 1\nv 1 1 1\n"
    "v 0 1 +1e0\nvt 0 0\nvn 0 0 1\ng all\nusemtl red\ns off\n";

TEST(Stl, IsReadAsTextAndAsBinary) {
    expect_solid("a.stl", test::binary_stl(ball), ball_volume, 1e-4);
    expect_solid("a.STL", test::ascii_stl(ball), ball_volume, 1e-3);
}

TEST(Stl, MayBeBinaryAndBeginWithSolid) {
    expect_solid("a.stl", test::binary_stl(ball, "solid Exported by a program"), ball_volume, 1e-4);
    expect_solid("a.stl", test::binary_stl(ball, "solid") + "trailing bytes", ball_volume, 1e-4);
}

TEST(Stl, TakesUpperCaseCarriageReturnsAndManySolids) {
    const std::string facet =
        "FACET NORMAL 0 0 1\r\nOUTER LOOP\r\nVERTEX 0 0 0\r\nVERTEX 1 0 0\r\nVERTEX 0 1e0 0\r\n"
        "ENDLOOP\r\nENDFACET\r\n";
    EXPECT_EQ(read("a.stl", "SOLID a\r\n" + facet + "ENDSOLID\r\nsolid b\r\n" + facet + facet + "endsolid b")
                  .triangles.size(),
              3U);
}

TEST(Stl, TakesFacetsWithMoreThanThreeCorners) {
    const TriangleMesh mesh = read("a.stl",
                                   "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
                                   "vertex 0 1 0\nendloop\nendfacet\nendsolid\n");
    ASSERT_EQ(mesh.triangles.size(), 2U);
    for (const auto& [a, b, c] : mesh.triangles)
        EXPECT_EQ(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]), (Vec3d{0, 0, 1}));
}

TEST(Obj, IsReadInAllItsWaysToNameACorner) {
    const std::string tail = "f 5/1/1 6/1/1 7/1/1 8/1/1\nf 1//1 2//1 6//1 5//1\nf 2/1 3/1 7/1 6/1 # right\n";
    expect_solid("a.obj", obj_cube + "f 4 3 2 1\n" + tail + "f 3 4 8 7\nf 4 1 5 8\n", 1);
    expect_solid("a.obj", obj_cube + "f -5 -6 -7 -8\n" + tail + "f -6 -5 \\\n -1 -2\r\nf -5 -8 -4 -1", 1);
}

TEST(Obj, MayHaveFacesBeforeTheirVertices) {
    const std::string faces = "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    expect_solid("a.obj", faces + obj_cube, 1);
}

TEST(Ply, IsReadInAllThreeEncodings) {
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
        expect_solid("a.ply", test::ply_cube(format), 1);
}

TEST(Ply, TakesFacesBeforeVertices) {
    EXPECT_EQ(
        read("a.ply",
             "ply\nformat ascii 1.0\nelement face 1\nproperty list uint8 uint32 vertex_index\nelement vertex 3\n"
             "property float32 x\nproperty float32 y\nproperty float32 z\nend_header\n3 0 1 2\n0 0 0 1 0 0 0 1 0\n")
            .triangles.size(),
        1U);
}

TEST(MeshFile, IsKnownByItsContentWhereItsNameSaysNothing) {
    expect_solid("a.dat", test::binary_stl(ball), ball_volume, 1e-4);
    expect_solid("a", test::ascii_stl(ball), ball_volume, 1e-3);
    expect_solid("b", test::ply_cube("ascii"), 1);
    EXPECT_EQ(read("c", "# cube\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").triangles.size(), 1U);
}

TEST(MeshFile, ReadsNumbersOfAllSizes) {
    const TriangleMesh mesh = read("a.obj", "v 1e-400 -1e-400 1e300\nv +.5 5. -0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(mesh.vertices[0], (Vec3d{0, 0, 1e300}));
    EXPECT_EQ(mesh.vertices[1], (Vec3d{0.5, 5, 0}));
}

}  // namespace

#include <gtest/gtest.h>
#include <random>

#include "formats/mesh/mesh_file.hpp"
#include "rt_core/api/error.hpp"
#include "tests/mesh_files/sample_meshes.hpp"
#include "tests/mesh_files/temporary_file.hpp"

namespace {

using namespace cardioid;
using test::TemporaryFile;

/// What the reader says of a file that it refuses, without the folder.
std::string refusal(const std::string& name, const std::string& text, ErrorCode code = ErrorCode::bad_input) {
    const TemporaryFile file(name, text);
    try {
        formats::read_mesh(file.path());
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
        const std::string what = error.what(), path = file.path();
        EXPECT_TRUE(what.starts_with(path + ":")) << what;
        return what.substr(path.size() + 1);
    }
    return "no refusal";
}

const TriangleMesh ball = csg::faceted_sphere(3, 8);
const std::string facet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string ply_head =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n";

TEST(BadMeshFile, IsRefusedWhereThereIsNone) {
    EXPECT_THROW(formats::read_mesh("/nonexistent/a.stl"), Error);
    try {
        formats::read_mesh(std::filesystem::temp_directory_path().string());
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::io);
        EXPECT_NE(std::string(error.what()).find("found a directory"), std::string::npos);
    }
}

TEST(BadMeshFile, IsRefusedWhenEmpty) {
    for (const char* name : {"a.stl", "a.obj", "a.ply", "a"})
        EXPECT_EQ(refusal(name, ""), "1: found an empty file, wanted a mesh");
    EXPECT_EQ(refusal("a", "hello"),
              "1: found no known mesh format, wanted STL, OBJ, PLY, OFF, AMF, 3MF, NEF3 or glTF");
    EXPECT_EQ(refusal("a.stl", "solid\nendsolid\n"), "1: found no faces, wanted at least one");
    EXPECT_EQ(refusal("a.obj", triangle), "1: found no faces, wanted at least one");
}

TEST(BadStl, NamesTheByteWhereItsCountLies) {
    EXPECT_EQ(refusal("a.stl", test::binary_stl(ball, "x", 0xFFFFFFFF)),
              "byte 80: found a count of 4294967295 triangles, wanted at most 60, for which the file has room");
    EXPECT_EQ(refusal("a.stl", test::binary_stl(ball).substr(0, 1000)),
              "byte 80: found a count of 60 triangles, wanted at most 18, for which the file has room");
    EXPECT_EQ(refusal("a.stl", "hello"), "byte 0: found 5 bytes, wanted \"solid\" or at least 84 bytes of binary STL");
}

TEST(BadStl, NamesTheByteOfACornerThatIsNotFinite) {
    TriangleMesh mesh = ball;
    mesh.vertices[mesh.triangles[1][0]].x = NAN;
    EXPECT_NE(refusal("a.stl", test::binary_stl(mesh)).find("found a corner that is not finite"), std::string::npos);
}

TEST(BadStl, NamesTheLine) {
    EXPECT_EQ(refusal("a.stl", "solid\n" + facet), "9: found the end of the file, wanted \"endsolid\"");
    EXPECT_EQ(refusal("a.stl", "solid\nfacet normal 0 0 1\nouter lop\n"), "3: found \"lop\", wanted \"loop\"");
    EXPECT_EQ(refusal("a.stl", "solid\n" + facet.substr(0, 50)), "5: found the end of the file, wanted a number");
    EXPECT_EQ(refusal("a.stl", "solid\nfacet normal 0 0 1 outer loop vertex 1 2 nan"),
              "2: found \"nan\", wanted a finite number");
    EXPECT_EQ(refusal("a.stl", "solid\nfacet normal 0 0 1 outer loop\nvertex 1,5 2 3"),
              "3: found \"1,5\", wanted a number");
    EXPECT_EQ(refusal("a.stl", "solid\nfacet normal 0 0 1 outer loop\nvertex 1e999 2 3"),
              "3: found \"1e999\", wanted a number");
    EXPECT_EQ(refusal("a.stl", "solid\nfacet normal 0 0 1 outer loop\nvertex 1 2 3\nendloop"),
              "4: found \"endloop\", wanted at least three corners");
}

TEST(BadObj, NamesTheLine) {
    EXPECT_EQ(refusal("a.obj", triangle + "f 1 2 4\nf 1 2 3\n"), "4: found \"4\", wanted one of the file's 3 vertices");
    EXPECT_EQ(refusal("a.obj", triangle + "f 1 2 0"),
              "4: found \"0\", wanted a vertex number from 1, or down from -1 to -3");
    EXPECT_EQ(refusal("a.obj", triangle + "f 1 2 -4/1"),
              "4: found \"-4/1\", wanted a vertex number from 1, or down from -1 to -3");
    EXPECT_EQ(refusal("a.obj", triangle + "f 1 2 99999999999999999999"),
              "4: found \"99999999999999999999\", wanted a vertex number, as 7 or 7/1/3");
    EXPECT_EQ(refusal("a.obj", triangle + "f 1 2\n\n"),
              "4: found the end of the line, wanted at least three corners of a face");
    EXPECT_EQ(refusal("a.obj", "v 1 2\n"), "1: found the end of the line, wanted a coordinate");
    EXPECT_EQ(refusal("a.obj", "v 1 2 inf\n"), "1: found \"inf\", wanted a finite number");
}

TEST(BadPly, NamesTheLineOfItsHeader) {
    EXPECT_EQ(refusal("a.ply", "plx\n"), "1: found \"plx\", wanted \"ply\"");
    EXPECT_EQ(refusal("a.ply", "ply\nformat binary 1.0\n"),
              "2: found \"binary\", wanted \"ascii\", \"binary_little_endian\" or \"binary_big_endian\"");
    EXPECT_EQ(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex -3\n"),
              "3: found \"-3\", wanted the number of elements");
    EXPECT_EQ(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty list float int a\n"),
              "4: found \"a list counted by fractions\", wanted a whole type before the list's type");
    EXPECT_EQ(refusal("a.ply", "ply\nformat ascii 1.0\nproperty float x\n"),
              "3: found \"property\", wanted \"element\" before it");
    EXPECT_EQ(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"),
              "4: found the end of the file, wanted \"end_header\"");
    EXPECT_EQ(refusal("a.ply", "ply\nend_header\n"), "2: found \"end_header\", wanted a line \"format\" before it");
    EXPECT_EQ(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"),
              "5: found \"end_header\", wanted an element \"vertex\" with properties x, y and z");
}

TEST(BadPly, NamesTheLineOfItsData) {
    EXPECT_EQ(refusal("a.ply", ply_head + "0 1 0\n3 0 1 3\n"),
              "13: found \"vertex 3\", wanted one of the file's 3 vertices, counted from 0");
    EXPECT_EQ(refusal("a.ply", ply_head + "0 1 0\n3 0 1 1.5\n"),
              "13: found \"vertex 1.5\", wanted one of the file's 3 vertices, counted from 0");
    EXPECT_EQ(refusal("a.ply", ply_head + "0 1 nan\n3 0 1 2\n"), "12: found \"nan\", wanted a finite number");
    EXPECT_EQ(refusal("a.ply", ply_head + "0 1 0\n3 0 1"), "13: found the end of the file, wanted a number");
    EXPECT_EQ(refusal("a.ply", ply_head + "0 1 0\n-3 0 1 2"),
              "13: found \"a list of -3 values\", wanted as many as the file holds");
}

TEST(BadPly, DoesNotBelieveItsCounts) {
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        EXPECT_NE(
            refusal("a.ply", test::ply_cube(format, "9000000000000000000")).find("as many as the file has room for"),
            std::string::npos);
        EXPECT_NE(refusal("a.ply", test::ply_cube(format, "7")), "no refusal");
    }
    EXPECT_NE(refusal("a.ply", ply_head + "0 1 0\n4000000000 0 1 2").find("a list of 4000000000 values"),
              std::string::npos);
    EXPECT_NE(refusal("a.ply",
                      "ply\nformat binary_little_endian 1.0\nelement nothing 9000000000000000000\n"
                      "element vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
                      "element face 0\nproperty list uchar int vertex_indices\nend_header\n"),
              "no refusal");
}

/// Truncated and bit-flipped files either read or are refused with an Error; sanitizers watch the rest.
TEST(BadMeshFile, SurvivesDamage) {
    std::mt19937 rng(3);
    const std::pair<const char*, std::string> files[] = {
        {"a.stl", test::binary_stl(ball)},
        {"a.stl", test::ascii_stl(ball)},
        {"a.obj", triangle + "v 0 0 1\nf 1/2/3 2 3 4\nf -1 -2 -3\n"},
        {"a.ply", test::ply_cube("ascii")},
        {"a.ply", test::ply_cube("binary_little_endian")},
        {"a.ply", test::ply_cube("binary_big_endian")},
    };
    for (const auto& [name, text] : files)
        for (int round = 0; round < 150; ++round) {
            std::string damaged = text.substr(0, round % 3 == 0 ? rng() % text.size() : text.size());
            for (int flips = round % 4; flips > 0 && !damaged.empty(); --flips)
                damaged[rng() % damaged.size()] ^= static_cast<char>(1U << rng() % 8);
            const TemporaryFile file(name, damaged);
            try {
                const TriangleMesh mesh = formats::read_mesh(file.path());
                for (const auto& t : mesh.triangles)
                    for (const std::uint32_t v : t) EXPECT_LT(v, mesh.vertices.size());
            } catch (const Error&) {  // refused
            }
        }
}

}  // namespace

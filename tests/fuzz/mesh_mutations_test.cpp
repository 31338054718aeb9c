#include <gtest/gtest.h>

#include "formats/figure/figure_file.hpp"
#include "formats/mesh/readers.hpp"
#include "formats/mesh/zip_archive.hpp"
#include "tests/fuzz/mutate.hpp"
#include "tests/mesh_files/nef3_frame.hpp"
#include "tests/mesh_files/sample_meshes.hpp"

namespace cardioid::formats {
namespace {

using test::survive;

using Reader = void (*)(const MeshText&, MeshBuilder&);

/// As read_mesh, without the disk.
void survive_mesh(Reader reader, const std::string& sample, unsigned seed) {
    const auto read = [reader](const std::string& bytes) {
        MeshBuilder mesh;
        reader({bytes, "damaged"}, mesh);
        return mesh.has_faces() ? mesh.finish().triangles.size() : 0;
    };
    EXPECT_GT(read(sample), 0U);
    survive(sample, seed, [&](const std::string& bytes) { static_cast<void>(read(bytes)); });
}

TriangleMesh tetrahedron() {
    return {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
            .triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

TEST(DamagedMeshes, OfEveryFormatAreReadOrRefused) {
    survive_mesh(read_stl, test::ascii_stl(tetrahedron()), 11);
    survive_mesh(read_stl, test::binary_stl(tetrahedron()), 12);
    survive_mesh(read_ply, test::ply_cube("ascii"), 13);
    survive_mesh(read_ply, test::ply_cube("binary_little_endian"), 14);
    survive_mesh(read_ply, test::ply_cube("binary_big_endian"), 15);
    survive_mesh(read_obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1/1 2/2/3 4//1\nf -3 -2 -1\nf 1 4 3\n", 16);
    survive_mesh(read_off, "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n", 17);
    survive_mesh(read_amf,
                 "<?xml version=\"1.0\"?><amf unit=\"millimeter\"><object id=\"0\"><mesh><vertices>"
                 "<vertex><coordinates><x>0</x><y>0</y><z>0</z></coordinates></vertex>"
                 "<vertex><coordinates><x>1</x><y>0</y><z>0</z></coordinates></vertex>"
                 "<vertex><coordinates><x>0</x><y>1</y><z>0</z></coordinates></vertex></vertices>"
                 "<volume><triangle><v1>0</v1><v2>1</v2><v3>2</v3></triangle></volume></mesh></object></amf>",
                 18);
    survive_mesh(
        read_gltf,
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[1,2,1]}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":4}]}],"accessors":[{"bufferView":0,)"
        R"("componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
        R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
        R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})",
        19);
}

TEST(DamagedMeshes, InArchivesAreReadOrRefused) {
    const std::string model =
        "<model unit=\"inch\"><resources><object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex "
        "x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"1\" z=\"0\"/></vertices><triangles><triangle v1=\"0\" "
        "v2=\"1\" v3=\"2\"/></triangles></mesh></object><object id=\"2\"><components><component objectid=\"1\" "
        "transform=\"2 0 0 0 1 0 0 0 1 5 6 7\"/></components></object></resources><build><item objectid=\"2\"/>"
        "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/></build></model>";
    const auto archive = [](const std::string& text) { return zip({{"3D/3dmodel.model", text}}); };
    survive_mesh(read_3mf, archive(model), 31);
    survive(model, 32, [&](const std::string& text) {
        MeshBuilder mesh;
        read_3mf({archive(text), "damaged"}, mesh);
    });
}

TEST(DamagedMeshes, OfNefPolyhedraAreReadOrRefused) { survive_mesh(read_nef3, test::nef3_frame(), 33); }

TEST(DamagedDrawings, AreReadOrRefused) {
    survive(
        "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n4\n21\n0\n0\nLWPOLYLINE\n90\n3\n70\n1\n10\n0\n20\n0"
        "\n"
        "42\n0.5\n10\n1\n20\n0\n10\n1\n20\n1\n0\nARC\n10\n0\n20\n0\n40\n2\n50\n0\n51\n90\n0\nENDSEC\n0\nEOF\n",
        21, [](const std::string& text) { static_cast<void>(read_dxf(text, "drawing.dxf", {})); });
    survive(
        "<svg width=\"10mm\" height=\"10mm\" viewBox=\"0 0 10 10\"><g transform=\"rotate(30) scale(2)\">"
        "<path d=\"M0 0 L4 0 C4 2 2 4 0 4 A1 2 30 0 1 -1 -1 q1 1 2 0 z\"/><rect width=\"3\" height=\"2\" rx=\"1\"/>"
        "<circle r=\"2\"/><polygon points=\"0,0 1,0 1,1\"/></g></svg>",
        22, [](const std::string& text) { static_cast<void>(read_svg(text, "drawing.svg", {})); });
}

}  // namespace
}  // namespace cardioid::formats

#include <gtest/gtest.h>

#include "csg/shapes/mesh_repair.hpp"
#include "formats/mesh/mesh_file.hpp"
#include "formats/mesh/zip_archive.hpp"
#include "rt_core/api/error.hpp"
#include "tests/mesh_files/nef3_frame.hpp"
#include "tests/mesh_files/sample_meshes.hpp"
#include "tests/mesh_files/temporary_file.hpp"

// OFF, AMF, 3MF and glTF.
namespace {

using namespace cardioid;
using test::TemporaryFile;

double volume_of(const std::string& name, const std::string& bytes) {
    const TemporaryFile file(name, bytes);
    TriangleMesh mesh = formats::read_mesh(file.path());
    EXPECT_TRUE(csg::weld(mesh).closed()) << name;
    return csg::volume(mesh);
}

std::string error_of(const std::string& name, const std::string& bytes) {
    const TemporaryFile file(name, bytes);
    try {
        formats::read_mesh(file.path());
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A tetrahedron of volume 1/6, its faces seen from outside.
constexpr int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
constexpr double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

std::string off() {
    std::string out = "OFF # a comment\n4 4 0\n";
    for (const auto& c : corners)
        out += std::to_string(c[0]) + " " + std::to_string(c[1]) + " " + std::to_string(c[2]) + "\n";
    for (const auto& f : faces)
        out += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + " 255 0 0\n";
    return out;
}

std::string amf(const std::string& unit) {
    std::string out = "<?xml version=\"1.0\"?>\n<amf unit=\"" + unit + "\"><object id=\"0\"><mesh><vertices>";
    for (const auto& c : corners)
        out += "<vertex><coordinates><x>" + std::to_string(c[0]) + "</x><y>" + std::to_string(c[1]) + "</y><z>" +
               std::to_string(c[2]) + "</z></coordinates></vertex>";
    out += "</vertices><volume>";
    for (const auto& f : faces)
        out += "<triangle><v1>" + std::to_string(f[0]) + "</v1><v2>" + std::to_string(f[1]) + "</v2><v3>" +
               std::to_string(f[2]) + "</v3></triangle>";
    return out + "</volume></mesh></object></amf>\n";
}

std::string model_xml(const std::string& items) {
    std::string out = "<model unit=\"millimeter\"><resources><object id=\"1\" type=\"model\"><mesh><vertices>";
    for (const auto& c : corners)
        out += "<vertex x=\"" + std::to_string(c[0]) + "\" y=\"" + std::to_string(c[1]) + "\" z=\"" +
               std::to_string(c[2]) + "\"/>";
    out += "</vertices><triangles>";
    for (const auto& f : faces)
        out += "<triangle v1=\"" + std::to_string(f[0]) + "\" v2=\"" + std::to_string(f[1]) + "\" v3=\"" +
               std::to_string(f[2]) + "\"/>";
    return out + "</triangles></mesh></object></resources><build>" + items + "</build></model>";
}

std::string three_mf(const std::string& items) {
    return formats::zip({{"[Content_Types].xml", "<Types/>"}, {"3D/3dmodel.model", model_xml(items)}});
}

std::string glb(const std::string& node) {
    std::string binary;
    for (const auto& c : corners)
        for (const double x : c) binary += test::bytes_of(static_cast<float>(x));
    for (const auto& f : faces)
        for (const int v : f) binary += test::bytes_of(static_cast<std::uint16_t>(v));
    std::string json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + node +
                       R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)"
                       R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
                       R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],"bufferViews":[)"
                       R"({"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],)"
                       R"("buffers":[{"byteLength":72}]})";
    while (json.size() % 4 != 0) json += ' ';
    const auto chunk = [](const std::string& kind, const std::string& data) {
        return test::bytes_of(static_cast<std::uint32_t>(data.size())) + kind + data;
    };
    const std::string chunks = chunk("JSON", json) + chunk(std::string("BIN\0", 4), binary);
    return "glTF" + test::bytes_of(std::uint32_t{2}) + test::bytes_of(static_cast<std::uint32_t>(12 + chunks.size())) +
           chunks;
}

TEST(Off, IsReadWithCommentsAndColours) {
    EXPECT_NEAR(volume_of("a.off", off()), 1.0 / 6, 1e-12);
    EXPECT_TRUE(contains(error_of("a.off", "OFF\n1 1 0\n0 0 0\n3 0 1 2\n"),
                         "a.off:4: found \"1\", wanted a vertex number below 1"));
    EXPECT_TRUE(contains(error_of("a.off", "OFF\n2 1"), "a.off:2: found the end"));
}

TEST(Amf, IsReadWithNumbersAsWritten) {
    EXPECT_NEAR(volume_of("a.amf", amf("millimeter")), 1.0 / 6, 1e-12);
    EXPECT_NEAR(volume_of("a.amf", amf("inch")), 1.0 / 6, 1e-12);
    EXPECT_NEAR(volume_of("a.amf", formats::zip({{"a.amf", amf("millimeter")}})), 1.0 / 6, 1e-12);
    EXPECT_TRUE(contains(error_of("a.amf", "<amf>\n<object>"), "a.amf:2: no XML"));
}

TEST(ThreeMf, IsReadAsTheBuildPlacesIt) {
    EXPECT_NEAR(volume_of("a.3mf", three_mf("<item objectid=\"1\"/>")), 1.0 / 6, 1e-12);
    EXPECT_NEAR(volume_of("a.3mf", three_mf("<item objectid=\"1\" transform=\"2 0 0 0 1 0 0 0 1 5 6 7\"/>")), 2.0 / 6,
                1e-12);
    EXPECT_NEAR(volume_of("a.3mf", three_mf("<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>")), 1.0 / 6,
                1e-12);
    EXPECT_TRUE(
        contains(error_of("a.3mf", three_mf("<item objectid=\"7\"/>")), "found object \"7\" that is not there"));
    EXPECT_TRUE(contains(error_of("a.3mf", "PK\3\4 nothing"), "wanted a ZIP archive"));
}

TEST(ThreeMf, OfAnyBytesIsRefusedNotBelieved) {
    const std::string good = three_mf("<item objectid=\"1\"/>");
    for (std::size_t at = 0; at < good.size(); at += 3) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 0x55);
        static_cast<void>(error_of("a.3mf", bad));
        static_cast<void>(error_of("a.3mf", good.substr(0, at)));
    }
}

TEST(Gltf, IsReadAsItsNodesPlaceIt) {
    EXPECT_NEAR(volume_of("a.glb", glb(R"({"mesh":0})")), 1.0 / 6, 1e-7);
    EXPECT_NEAR(volume_of("a.glb", glb(R"({"mesh":0,"scale":[2,1,1],"translation":[5,0,0],"rotation":[0,0,0,1]})")),
                2.0 / 6, 1e-7);
    EXPECT_NEAR(volume_of("a.glb", glb(R"({"mesh":0,"matrix":[1,0,0,0,0,3,0,0,0,0,1,0,0,0,0,1]})")), 3.0 / 6, 1e-7);
    EXPECT_TRUE(contains(error_of("a.glb", glb(R"({"mesh":7})")), "no glTF"));
    EXPECT_TRUE(contains(error_of("a.gltf", "{"), "no glTF"));
}

TEST(MoreMeshFormats, ReadFacetsWithHolesOfANefPolyhedron) {
    EXPECT_NEAR(volume_of("a.nef3", test::nef3_frame()), 8, 1e-12);
    EXPECT_NEAR(volume_of("told-by-content", test::nef3_frame()), 8, 1e-12);
}

TEST(MoreMeshFormats, NameTheLineOfANefPolyhedronThatIsBroken) {
    const std::string good = test::nef3_frame();
    const auto broken = [&](const std::string& part, const std::string& instead) {
        std::string text = good;
        text.replace(text.find(part), part.size(), instead);
        return error_of("a.nef3", text);
    };
    EXPECT_TRUE(contains(broken("standard", "extended"), "a.nef3:2: found \"extended\", wanted \"standard\""));
    EXPECT_TRUE(contains(broken("| 0 0 0 7", "| 0 a 0 7"), "a.nef3:10: found \"a\", wanted a coordinate"));
    EXPECT_TRUE(contains(broken("| 0 0 0 7", "| 0 0 0 0"), "wanted a point that is not at infinity"));
    EXPECT_TRUE(contains(broken("0, 8, 0 0 |", "0, 99, 0 0 |"), "found \"99\", wanted a vertex's number"));
    EXPECT_TRUE(contains(broken("3, 0, 0, 0, 0 |", "3, 0, 0, 1, 0 |"), "wanted shalfedges in closed chains"));
    for (std::size_t end = 30; end + 40 < good.size(); end += 61)
        EXPECT_TRUE(contains(error_of("a.nef3", good.substr(0, end)), "a.nef3:")) << end;
}

}  // namespace

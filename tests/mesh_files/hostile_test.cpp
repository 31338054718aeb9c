#include <gtest/gtest.h>

#include "formats/figure/figure_file.hpp"
#include "formats/figure/join_lines.hpp"
#include "formats/mesh/readers.hpp"
#include "formats/mesh/zip_archive.hpp"
#include "rt_core/api/error.hpp"

// Small files that ask for endless work, and numbers beyond what readers compute with.
namespace {

using namespace cardioid;

template <class Read>
ErrorCode refusal(Read&& read) {
    try {
        read();
    } catch (const Error& e) {
        return e.code();
    }
    ADD_FAILURE() << "nothing was refused";
    return ErrorCode::interrupted;
}

std::size_t lines_of_dxf(const std::string& entities) {
    const formats::FigureFile file =
        formats::read_dxf("0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n", "a.dxf", {});
    return file.figures.empty() ? 0 : file.figures[0].contours[0].size();
}

TEST(HostileDrawings, HaveArcsOfAnyAngleThatGoAroundOnce) {
    for (const char* angle : {"4294967295", "1e300", "-1e300", "1e308"}) {
        EXPECT_LT(lines_of_dxf("0\nARC\n10\n0\n20\n0\n40\n2\n50\n0\n51\n" + std::string(angle) + "\n"), 40U);
        EXPECT_LT(
            lines_of_dxf("0\nELLIPSE\n10\n0\n20\n0\n11\n4\n21\n0\n40\n0.5\n41\n0\n42\n" + std::string(angle) + "\n"),
            40U);
    }
    EXPECT_EQ(lines_of_dxf("0\nARC\n10\n0\n20\n0\n40\n2\n50\n90\n51\n450\n"),
              lines_of_dxf("0\nCIRCLE\n10\n0\n20\n0\n40\n2\n"));
}

TEST(HostileDrawings, WhoseBlocksInsertThemselvesAreRefused) {
    std::string text = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n0\nLINE\n10\n0\n20\n0\n11\n1\n21\n1\n";
    for (int i = 0; i < 60; ++i) text += "0\nINSERT\n2\nB\n10\n1\n20\n0\n";
    EXPECT_EQ(refusal([&] { formats::read_dxf(text + "0\nENDBLK\n0\nEOF\n", "a.dxf", {}); }), ErrorCode::limit);
}

TEST(HostileDrawings, WhoseElementsUseEachOtherAreRefused) {
    std::string text = "<svg width=\"9mm\" height=\"9mm\"><g id=\"a0\"><rect width=\"1\" height=\"1\"/></g>";
    for (int i = 1; i < 60; ++i) {
        const std::string last = "<use href=\"#a" + std::to_string(i - 1) + "\"/>";
        text += "<g id=\"a" + std::to_string(i) + "\">" + last + last + "</g>";
    }
    EXPECT_EQ(refusal([&] { formats::read_svg(text + "</svg>", "a.svg", {}); }), ErrorCode::limit);
}

TEST(HostileDrawings, WithPointsBeyondAllNumbersAreRefused) {
    const auto read = [](const std::string& inside) {
        return refusal(
            [&] { formats::read_svg("<svg width=\"9mm\" height=\"9mm\">" + inside + "</svg>", "a.svg", {}); });
    };
    EXPECT_EQ(read("<g transform=\"scale(1e308)\"><rect x=\"1e9\" width=\"1e9\" height=\"2\"/></g>"),
              ErrorCode::bad_input);
    EXPECT_EQ(read("<polyline points=\"0,0 1e12,0 3,3\"/>"), ErrorCode::bad_input);  // a wide line
    EXPECT_EQ(read("<polyline points=\"0,0 1,0 3,3\" style=\"stroke-width:1e12\"/>"), ErrorCode::bad_input);
    const formats::FigureFile arc = formats::read_svg(
        "<svg width=\"9mm\" height=\"9mm\"><path d=\"M0 0 A1e200 1e200 0 0 1 4 0 L4 4 z\"/></svg>", "a.svg", {});
    EXPECT_EQ(arc.figures.size(), 1U);
}

TEST(HostileDrawings, JoinLinesWhoseEndsAreBeyondTheGrid) {
    const double far = 1e300;
    EXPECT_EQ(formats::join_lines({{{0, 0}, {far, 0}}, {{far, 0}, {0, far}}, {{0, far}, {0, 0}}}).size(), 1U);
    EXPECT_EQ(formats::join_lines({{{0, 0}, {-far, -far}}, {{-far, -far}, {1, 0}}, {{1, 0}, {0, 0}}}).size(), 1U);
}

TEST(HostileMeshes, WhoseComponentsDoubleEachOtherAreRefused) {
    std::string text = "<model><resources><object id=\"0\"/>";
    for (int i = 1; i < 60; ++i) {
        const std::string last = "<component objectid=\"" + std::to_string(i - 1) + "\"/>";
        text += "<object id=\"" + std::to_string(i) + "\"><components>" + last + last + "</components></object>";
    }
    text = formats::zip({{"a.model", text + "</resources><build><item objectid=\"59\"/></build></model>"}});
    formats::MeshBuilder mesh;
    EXPECT_EQ(refusal([&] { formats::read_3mf({text, "a.3mf"}, mesh); }), ErrorCode::limit);
}

TEST(HostileMeshes, WhoseNodesDoubleEachOtherAreRefused) {
    std::string text = R"({"scenes":[{"nodes":[59]}],"nodes":[{})";
    for (int i = 1; i < 60; ++i) {
        const std::string last = std::to_string(i - 1);
        text += R"(,{"children":[)" + last + "," + last + "]}";
    }
    formats::MeshBuilder mesh;
    EXPECT_EQ(refusal([&] { formats::read_gltf({text + "]}", "a.gltf"}, mesh); }), ErrorCode::limit);
}

TEST(HostileMeshes, WhoseStridesPassTheEndOfMemoryAreRefused) {
    const std::string text =
        R"({"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,)"
        R"("byteStride":9223372036854775808}],"buffers":[{"uri":"data:application/octet-stream;base64,)"
        R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
    formats::MeshBuilder mesh;
    EXPECT_EQ(refusal([&] { formats::read_gltf({text, "a.gltf"}, mesh); }), ErrorCode::bad_input);
}

}  // namespace

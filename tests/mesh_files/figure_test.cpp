#include <gtest/gtest.h>
#include <numbers>

#include "csg/shapes/profile_boolean.hpp"
#include "formats/figure/figure_file.hpp"
#include "rt_core/api/error.hpp"

// Drawings: DXF and SVG.
namespace {

using namespace cardioid;
using formats::FigureFile;
using formats::FigureOptions;

double area(const Profile& profile) {
    double out = 0;
    for (const auto& contour : profile.contours)
        for (std::size_t i = 0; i < contour.size(); ++i)
            out += cross(contour[i], contour[(i + 1) % contour.size()]) / 2;
    return out;
}

/// The area of all figures together.
double area(const FigureFile& file) { return area(csg::profile_boolean(csg::ProfileOp::unite, file.figures, 0x1p-16)); }

double dxf_area(const std::string& entities, const FigureOptions& options = {}, const std::string& blocks = "") {
    const std::string text =
        "0\nSECTION\n2\nBLOCKS\n" + blocks + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
    return area(formats::read_dxf(text, "a.dxf", options));
}

std::string line(double x1, double y1, double x2, double y2, const std::string& layer = "0") {
    return "0\nLINE\n8\n" + layer + "\n10\n" + std::to_string(x1) + "\n20\n" + std::to_string(y1) + "\n11\n" +
           std::to_string(x2) + "\n21\n" + std::to_string(y2) + "\n";
}

const std::string triangle = line(0, 0, 4, 0) + line(0, 3, 0, 0) + line(4, 0, 0, 3);

double svg_area(const std::string& inside, const FigureOptions& options = {}) {
    return area(formats::read_svg("<svg width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\">" + inside + "</svg>",
                                  "a.svg", options));
}

TEST(Dxf, JoinsLinesWhoseEndsMeet) {
    EXPECT_NEAR(dxf_area(triangle), 6, 1e-4);
    EXPECT_NEAR(dxf_area(line(0, 0, 4, 0) + line(4, 0, 0, 3)), 6, 1e-4);  // closed where it is open
}

TEST(Dxf, TakesTheLayerOriginAndScaleItIsTold) {
    const std::string two = triangle + line(10, 0, 11, 0, "b") + line(11, 0, 11, 1, "b") + line(11, 1, 10, 0, "b");
    FigureOptions options;
    EXPECT_NEAR(dxf_area(two, options), 6.5, 1e-4);
    options.layer = "b";
    options.scale = 2;
    EXPECT_NEAR(dxf_area(two, options), 2, 1e-4);
}

TEST(Dxf, DrawsPolylinesCirclesArcsEllipsesAndBlocks) {
    FigureOptions fine;
    fine.smooth = true;
    const double pi = std::numbers::pi;
    EXPECT_NEAR(dxf_area("0\nLWPOLYLINE\n8\n0\n70\n1\n10\n0\n20\n0\n10\n2\n20\n0\n10\n2\n20\n2\n10\n0\n20\n2\n"), 4,
                1e-4);
    EXPECT_NEAR(dxf_area("0\nCIRCLE\n8\n0\n10\n5\n20\n5\n40\n2\n", fine), 4 * pi, 1e-2);
    EXPECT_NEAR(dxf_area("0\nARC\n8\n0\n10\n0\n20\n0\n40\n2\n50\n90\n51\n270\n", fine), 2 * pi, 1e-2);
    EXPECT_NEAR(dxf_area("0\nELLIPSE\n8\n0\n10\n0\n20\n0\n11\n4\n21\n0\n40\n0.5\n41\n0\n42\n6.283185307\n", fine),
                8 * pi, 2e-2);
    const std::string block = "0\nBLOCK\n2\nB\n" + triangle + "0\nENDBLK\n";
    EXPECT_NEAR(dxf_area("0\nINSERT\n8\n0\n2\nB\n10\n9\n20\n9\n41\n2\n42\n3\n50\n90\n", {}, block), 36, 1e-4);
}

TEST(Dxf, IsRefusedWithItsLineAndWarnsOfWhatItLeavesOut) {
    try {
        formats::read_dxf("0\nSECTION\nx\n", "a.dxf", {});
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("a.dxf:4: found \"x\", wanted a group code"), std::string::npos)
            << e.what();
    }
    const FigureFile file = formats::read_dxf("0\nSECTION\n2\nENTITIES\n0\nSPLINE\n8\n0\n0\nENDSEC\n", "a.dxf", {});
    ASSERT_EQ(file.warnings.size(), 1U);
    EXPECT_EQ(file.warnings[0], "a.dxf: 1 entities \"SPLINE\" are left out");
}

TEST(Svg, DrawsItsShapes) {
    FigureOptions fine;
    fine.smooth = true;
    const double pi = std::numbers::pi;
    EXPECT_NEAR(svg_area("<rect x=\"1\" y=\"2\" width=\"3\" height=\"4\"/>"), 12, 1e-3);
    EXPECT_NEAR(svg_area("<rect width=\"30\" height=\"40\" rx=\"5\"/>", fine), 1200 - (4 - pi) * 25, 2e-2);
    EXPECT_NEAR(svg_area("<circle cx=\"5\" cy=\"5\" r=\"2\"/>", fine), 4 * pi, 1e-2);
    EXPECT_NEAR(svg_area("<ellipse cx=\"5\" cy=\"5\" rx=\"2\" ry=\"3\"/>", fine), 6 * pi, 1e-2);
    EXPECT_NEAR(svg_area("<polygon points=\"0,0 4,0 0,3\"/>"), 6, 1e-3);
    EXPECT_NEAR(svg_area("<line x1=\"10\" y1=\"10\" x2=\"20\" y2=\"10\" stroke-width=\"2\" stroke-linecap=\"butt\"/>"),
                20, 1e-2);
}

TEST(Svg, DrawsPathsOfEveryCommand) {
    FigureOptions fine;
    fine.smooth = true;
    const double pi = std::numbers::pi;
    EXPECT_NEAR(svg_area("<path d=\"M0 0 L4,0 4 3-0 3z\"/>"), 12, 1e-3);
    EXPECT_NEAR(svg_area("<path d=\"m1,1h4v3h-4z m1 1h1v1h-1z\"/>"), 11, 1e-3);
    EXPECT_NEAR(svg_area("<path d=\"M0 0 A2 2 0 0 1 4 0z\"/>", fine), 2 * pi, 1e-2);
    EXPECT_NEAR(svg_area("<path d=\"M0 0 Q2 4 4 0z\"/>", fine), 4.0 * 4 * 2 / 6, 1e-2);
    EXPECT_NEAR(svg_area("<path d=\"M0 0 C0 4 4 4 4 0z\"/>", fine), 9.6, 2e-2);
    EXPECT_NEAR(svg_area("<path d=\"M 0 0 q 2 4 4 0 t 4 0 z\"/>", fine), 2 * 4.0 * 4 * 2 / 6, 2e-2);
}

TEST(Svg, StandsOnItsPageWithYUp) {
    const FigureFile file = formats::read_svg(
        "<svg width=\"100mm\" height=\"50mm\" viewBox=\"0 0 200 100\"><g transform=\"translate(10,20) scale(2)\">"
        "<rect width=\"10\" height=\"10\"/></g></svg>",
        "a.svg", {});
    Box3d box;
    for (const Vec2d p : file.figures.at(0).contours.at(0)) box.include(Vec3d{p.x, p.y, 0});
    EXPECT_NEAR(box.lo.x, 5, 1e-9);
    EXPECT_NEAR(box.hi.x, 15, 1e-9);
    EXPECT_NEAR(box.hi.y, 50 - 10, 1e-9);
    EXPECT_NEAR(box.lo.y, 50 - 20, 1e-9);
}

TEST(Svg, OfAnythingElseIsRefused) {
    EXPECT_THROW(formats::read_svg("<html/>", "a.svg", {}), Error);
    EXPECT_THROW(formats::read_svg("nothing", "a.svg", {}), Error);
}

}  // namespace

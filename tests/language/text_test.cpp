#include <gtest/gtest.h>

#include "csg/shapes/profile_boolean.hpp"
#include "formats/openscad/text/typeset.hpp"
#include "rt_core/api/error.hpp"
#include "tests/language/read.hpp"

namespace {

using namespace cardioid;
using namespace cardioid::test;
using formats::openscad::Glyphs;
using formats::openscad::typeset;
using formats::openscad::Typeset;

Box3d box_of(const Typeset& what) {
    Box3d out;
    for (const Profile& figure : typeset(what).figures)
        for (const auto& contour : figure.contours)
            for (const Vec2d p : contour) out.include(Vec3d{p.x, p.y, 0});
    return out;
}

Box3d box_with(void (*change)(Typeset&)) {
    Typeset what;
    what.text = "AgB";
    what.font = "DejaVu Sans";
    change(what);
    return box_of(what);
}

bool has_fonts() {
    try {
        return typeset({.text = "A", .font = "DejaVu Sans"}).missing_font.empty();
    } catch (const Error&) {
        return false;
    }
}

class Text : public testing::Test {
protected:
    void SetUp() override {
        if (!has_fonts()) GTEST_SKIP() << "fonts-dejavu-core is not installed";
    }
};

}  // namespace

TEST_F(Text, StandsOnTheBaselineAtTheOrigin) {
    // OpenSCAD 2021.01's own coordinates of text("AB") in DejaVu Sans.
    const Box3d a = box_of({.text = "A", .font = "DejaVu Sans"});
    EXPECT_NEAR(a.lo.x, 0.10849, 2e-4);
    EXPECT_NEAR(a.hi.x, 9.3853, 2e-4);
    EXPECT_NEAR(a.lo.y, 0, 2e-4);
    EXPECT_NEAR(a.hi.y, 10.1248, 2e-4);
}

TEST_F(Text, IsAlignedAsItIsTold) {
    const Box3d plain = box_with([](Typeset&) {});
    const auto moved = [&](void (*change)(Typeset&)) { return box_with(change).lo - plain.lo; };
    // From OpenSCAD 2021.01's SVG of text("AgB", ...).
    EXPECT_NEAR(moved([](Typeset& t) { t.halign = "center"; }).x, -13.5965, 2e-4);
    EXPECT_NEAR(moved([](Typeset& t) { t.halign = "right"; }).x, -27.193, 2e-4);
    EXPECT_NEAR(moved([](Typeset& t) { t.valign = "top"; }).y, -9.8875, 2e-4);
    EXPECT_NEAR(moved([](Typeset& t) { t.valign = "center"; }).y, -3.53436, 2e-4);
    EXPECT_NEAR(moved([](Typeset& t) { t.valign = "bottom"; }).y, 2.81874, 2e-4);
}

TEST_F(Text, IsWidenedBySpacingAndRunsDown) {
    const Box3d plain = box_with([](Typeset&) {});
    EXPECT_NEAR(box_with([](Typeset& t) { t.spacing = 2; }).hi.x - plain.hi.x, 17.888, 2e-3);
    const Box3d down = box_with([](Typeset& t) { t.direction = "ttb"; });
    EXPECT_LT(down.hi.y, 0);
    EXPECT_GT(down.size().y, 3 * down.size().x);
}

TEST_F(Text, GrowsWithItsSize) {
    const Box3d plain = box_with([](Typeset&) {}), twice = box_with([](Typeset&t) { t.size = 20; });
    EXPECT_NEAR(twice.hi.x, 2 * plain.hi.x, 1e-12);
}

TEST_F(Text, OfAFontThatIsNotThereUsesAnotherAndSaysSo) {
    const Scene scene = read("linear_extrude(1) text(\"A\", font = \"No Such Font\"); linear_extrude(1) text(\"A\");");
    EXPECT_EQ(scene.solids.roots.size(), 2U);
    EXPECT_TRUE(contains(warnings_of(scene), "font \"No Such Font\" is not installed"));
    EXPECT_EQ(scene.warnings.size(), 1U);
}

TEST_F(Text, HasItsHoles) {
    const Scene scene = read("linear_extrude(1) text(\"O\", font = \"DejaVu Sans\", $fn = 8);");
    ASSERT_EQ(scene.solids.profiles.size(), 1U);
    EXPECT_EQ(scene.solids.profiles[0]->contours.size(), 2U);
}

TEST_F(Text, OfNothingOrBadSizeIsEmpty) {
    EXPECT_EQ(tree_of(read("cube(1); linear_extrude(1) text(\" \");")), "box");
    EXPECT_TRUE(contains(warnings_of(read("cube(1); linear_extrude(1) text(\"A\", size = 0);")), "above 0 and finite"));
    EXPECT_TRUE(contains(warnings_of(read("cube(1); linear_extrude(1) text(\"A\", halign = \"centre\");")),
                         "text() has no halign \"centre\" (did you mean \"center\"?)"));
}

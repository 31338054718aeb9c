#include <gtest/gtest.h>

#include "formats/brlcad/look/rt_texture.hpp"
#include "formats/brlcad/look/uv_chart.hpp"
#include "formats/brlcad/scene/charts.hpp"

namespace cardioid::formats::brlcad {
namespace {

void expect_uv(const UvChart& chart, Vec3d p, Vec3 n, double u, double v) {
    const Vec2d found = chart.at(p, n);
    EXPECT_NEAR(found.x, u, 1e-12);
    EXPECT_NEAR(found.y, v, 1e-12);
}

TEST(BrlcadTextures, OfBallsFollowAzimuthAndElevation) {
    const Solid ball{.kind = SolidKind::ell, .numbers = {1, 2, 3, 2, 0, 0, 0, 4, 0, 0, 0, 6}, .type = "ell"};
    const UvChart chart(chart_of(ball, {}));
    expect_uv(chart, {3, 2, 3}, {1, 0, 0}, 0, 0.5);
    expect_uv(chart, {1, 6, 3}, {0, 1, 0}, 0.25, 0.5);
    expect_uv(chart, {1, -2, 3}, {0, -1, 0}, 0.75, 0.5);
    expect_uv(chart, {1, 2, 9}, {0, 0, 1}, 0, 1);
}

TEST(BrlcadTextures, OfConesFollowAzimuthAndHeight) {
    const Solid cone{
        .kind = SolidKind::tgc, .numbers = {0, 0, 0, 0, 0, 8, 4, 0, 0, 0, 4, 0, 2, 0, 0, 0, 2, 0}, .type = "tgc"};
    const UvChart chart(chart_of(cone, {}));
    expect_uv(chart, {0, 3, 4}, {0, 1, 0}, 0.75, 0.5);
    expect_uv(chart, {1, 0, 8}, {0, 0, 1}, 0.5, 0.5);
    expect_uv(chart, {1, 0, 0}, {0, 0, -1}, 0.5, 0.75);
}

TEST(BrlcadTextures, OfHalfSpacesRepeatEveryTenMetres) {
    const Solid half{.kind = SolidKind::half, .numbers = {0, 0, 1, -5}, .type = "half"};
    const UvChart chart(chart_of(half, {}));
    expect_uv(chart, {1000, 3000, -5}, {0, 0, 1}, 0.6, 0.2);
    expect_uv(chart, {-11000, 7000, -5}, {0, 0, 1}, 0.6, 0.2);
}

TEST(BrlcadTextures, OfBoxesCoverEachFaceOnce) {
    const Solid box{.kind = SolidKind::arb8,
                    .numbers = {0, 0, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0, 0, 0, 4, 2, 0, 4, 2, 3, 4, 0, 3, 4},
                    .type = "arb8"};
    const UvChart chart(chart_of(box, Affine::translation({10, 0, 0})));
    // Corners 4 3 2 1 below, 5 6 7 8 above: u along the first edge, v against the second.
    expect_uv(chart, {10.5, 3, 0}, {0, 0, -1}, 0.25, 1);
    expect_uv(chart, {10.5, 0, 4}, {0, 0, 1}, 0.25, 1);
    expect_uv(chart, {12, 3, 4}, {0, 0, 1}, 1, 0);
}

TEST(BrlcadTextures, HaveTheColoursOfTheirFormulas) {
    RtTexture texture;
    texture.kind = RtTexture::Kind::checker;
    EXPECT_EQ(texture.at({0.1, 0.2}), Rgb(1));
    EXPECT_EQ(texture.at({0.1, 0.7}), Rgb(0));
    EXPECT_EQ(texture.at({0.9, 0.7}), Rgb(1));
    texture.kind = RtTexture::Kind::testmap;
    EXPECT_EQ(texture.at({0.25, 0.5}), Rgb(0.25F, 0, 0.5F));
    // All sines are 0 where u and v are: four times four over twice as many, half as thick as can be.
    texture.kind = RtTexture::Kind::cloud;
    EXPECT_EQ(texture.at({0, 0}),
              Rgb(0.5F * 0.5F + 0.5F * 0.31F, 0.5F * 0.5F + 0.5F * 0.31F, 0.5F * 0.5F + 0.5F * 0.78F));
}

TEST(BrlcadTextures, OfWhatHasNoChartAreThoseOfItsOrigin) {
    const Solid part{.kind = SolidKind::part, .numbers = {0, 0, 0, 0, 0, 1, 1, 1}, .type = "part"};
    expect_uv(UvChart(chart_of(part, {})), {3, 4, 5}, {0, 0, 1}, 0, 0);
    const std::vector<double> short_of_numbers{1, 2, 3};
    expect_uv(UvChart(short_of_numbers), {3, 4, 5}, {0, 0, 1}, 0, 0);
}

}  // namespace
}  // namespace cardioid::formats::brlcad

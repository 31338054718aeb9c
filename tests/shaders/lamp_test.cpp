/// How transforms place lamps, and what radiance and power mean.
#include <gtest/gtest.h>

#include "make.hpp"

namespace cardioid::test {
namespace {

Affine quarter_turn_about_y() { return {{Vec3d{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}, {}}; }

TEST(Lamp, HasThePowerOfItsRadianceAndArea) {
    const double pi2 = std::numbers::pi * std::numbers::pi;
    const Affine twice = Affine::scaling({2, 2, 2});
    const auto power = [&](const char* kind, const Values& values) {
        return double{make_light(kind, values, twice)->power().r};
    };
    EXPECT_NEAR(power("area_light", {{"size", list({3, 5})}}), std::numbers::pi * 60, 1e-3);
    EXPECT_NEAR(power("disk_light", {{"r", number(3)}}), pi2 * 36, 1e-3);
    EXPECT_NEAR(power("sphere_light", {{"r", number(3)}}), 4 * pi2 * 36, 1e-3);
    for (const char* kind : {"area_light", "disk_light", "sphere_light"})
        EXPECT_NEAR(power(kind, {kind[0] == 'a' ? std::pair{"size", list({3, 5})} : std::pair{"r", number(1)},
                                 {"power", number(7)}}),
                    7, 1e-5);
    EXPECT_NEAR(power("point_light", {{"intensity", number(2)}}), 8 * std::numbers::pi, 1e-5);
    EXPECT_NEAR(power("point_light", {{"power", number(2)}}), 2, 1e-6);
    EXPECT_NEAR(power("spot_light", {{"angle", number(90)}}), 2 * std::numbers::pi, 1e-5);
    EXPECT_NEAR(power("spot_light", {{"angle", number(90)}, {"inner", number(0)}}), std::numbers::pi, 1e-5);
    EXPECT_NEAR(power("spot_light", {{"angle", number(180)}}), 4 * std::numbers::pi, 1e-5);
}

TEST(Lamp, ShinesAlongTheImageOfLocalMinusZ) {
    const auto light = make_light("area_light", {{"size", list({1, 1})}}, quarter_turn_about_y());
    EXPECT_EQ(light->emitted({}, {}, {-1, 0, 0}), Rgb(1));
    EXPECT_EQ(light->emitted({}, {}, {1, 0, 0}), Rgb{});
    EXPECT_FALSE(is_black(light->sample({-2, 0, 0}, {0.5F, 0.5F}).L));
    const auto mirrored = make_light("disk_light", {{"r", number(1)}}, Affine::scaling({-1, 1, 1}));
    EXPECT_EQ(mirrored->emitted({}, {}, {0, 0, -1}), Rgb(1));
    const auto upside_down = make_light("disk_light", {{"r", number(1)}}, Affine::scaling({1, 1, -1}));
    EXPECT_EQ(upside_down->emitted({}, {}, {0, 0, 1}), Rgb(1));
    const auto spot = make_light("spot_light", {}, quarter_turn_about_y());
    EXPECT_FALSE(is_black(spot->sample({-2, 0, 0}, {}).L));
    EXPECT_TRUE(is_black(spot->sample({2, 0, 0}, {}).L));
    const auto sun = make_light("sun", {{"direction", list({0, 0, -5})}, {"angle", number(0)}}, quarter_turn_about_y());
    EXPECT_NEAR(sun->sample({}, {}).wi.x, 1, 1e-6F);
}

TEST(Lamp, TellsTheTracerItsShape) {
    const Affine place = Affine::translation({1, 2, 3}) * Affine::scaling({2, 2, 2});
    const auto rectangle = make_light("area_light", {{"size", list({3, 5})}}, place)->shape();
    ASSERT_TRUE(rectangle);
    EXPECT_EQ(rectangle->kind, LampShape::Kind::rectangle);
    EXPECT_EQ(rectangle->size, (Vec2d{3, 5}));
    EXPECT_EQ(rectangle->to_world, place);
    const auto ball = make_light("sphere_light", {{"r", number(4)}}, place)->shape();
    ASSERT_TRUE(ball);
    EXPECT_EQ(ball->kind, LampShape::Kind::sphere);
    EXPECT_EQ(ball->size.x, 4);
    EXPECT_EQ(make_light("disk_light", {{"r", number(4)}}, place)->shape()->kind, LampShape::Kind::disc);
    EXPECT_FALSE(make_light("point_light")->shape());
    EXPECT_FALSE(make_light("sky")->shape());
}

TEST(Lamp, MustStayRoundAndSolid) {
    const Values round = {{"r", number(1)}};
    const auto fails = [&](const char* kind, const Values& values, const Affine& to_world) {
        return error_of([&] { make_light(kind, values, to_world); });
    };
    EXPECT_NE(fails("sphere_light", round, Affine::scaling({1, 1, 2})).find("scene.csg:3:7"), std::string::npos);
    EXPECT_NE(fails("disk_light", round, Affine::scaling({1, 2, 1})), "");
    EXPECT_EQ(fails("disk_light", round, Affine::scaling({2, 2, 1})), "");
    EXPECT_EQ(fails("area_light", {{"size", list({1, 1})}}, Affine::scaling({1, 2, 3})), "");
    EXPECT_NE(fails("area_light", {{"size", list({1, 1})}}, Affine::scaling({1, 2, 0})), "");
    EXPECT_NE(fails("area_light", {{"size", list({1, 1})}}, Affine::scaling({0, 2, 1})), "");
    EXPECT_NE(fails("spot_light", {}, Affine::scaling({1, 1, 0})), "");
    EXPECT_NE(fails("sphere_light", round, Affine::scaling({0, 0, 0})), "");
    Affine six_digits{{Vec3d{0.866025, -0.5, 0}, {0.5, 0.866025, 0}, {0, 0, 1}}, {}};
    EXPECT_EQ(fails("sphere_light", round, six_digits), "");
}

}  // namespace
}  // namespace cardioid::test

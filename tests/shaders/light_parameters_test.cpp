#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "make.hpp"

namespace cardioid::test {
namespace {

std::string fails(const char* kind, const Values& values) {
    return error_of([&] { make_light(kind, values); });
}

void expect_message(const std::string& got, const std::string& part) {
    EXPECT_NE(got.find("scene.csg:3:7"), std::string::npos) << got;
    EXPECT_NE(got.find(part), std::string::npos) << got;
}

TEST(LightParameters, OfWrongValuesAreRefusedWithTheirPlace) {
    const double nan = std::nan("");
    expect_message(fails("point_light", {{"intensity", number(-1)}}), "intensity = -1 must be at least 0");
    expect_message(fails("point_light", {{"intensity", number(nan)}}), "finite");
    expect_message(fails("point_light", {{"intensity", text("bright")}}), "a colour");
    expect_message(fails("point_light", {{"intensity", number(1)}, {"power", number(1)}}), "intensity");
    expect_message(fails("spot_light", {{"angle", number(0)}}), "above 0");
    expect_message(fails("spot_light", {{"angle", number(20)}, {"inner", number(30)}}), "between 0 and 20");
    expect_message(fails("area_light", {}), "size");
    expect_message(fails("area_light", {{"size", list({1})}}), "a list of 2 numbers");
    expect_message(fails("area_light", {{"size", list({1, 0})}}), "both above 0");
    expect_message(fails("area_light", {{"size", list({1, INFINITY})}}), "finite");
    expect_message(fails("disk_light", {}), "r must be given");
    expect_message(fails("sphere_light", {{"r", number(0)}}), "above 0");
    expect_message(fails("sphere_light", {{"r", number(-2)}}), "above 0");
    expect_message(fails("sphere_light", {{"r", number(1)}, {"power", number(1)}, {"radiance", number(1)}}), "power");
    expect_message(fails("sphere_light", {{"r", number(1)}, {"visible", text("no")}}), "true or false");
    expect_message(fails("sphere_light", {{"r", number(1e-30)}, {"power", number(1)}}), "smaller");
    expect_message(fails("sun", {}), "direction");
    expect_message(fails("sun", {{"direction", list({0, 0, 0})}}), "direction");
    expect_message(fails("sun", {{"direction", list({0, 0, -1})}, {"angle", number(200)}}), "between 0 and 180");
    expect_message(fails("sky", {{"radiance", text("studioo")}}), "\"studio\"");
    expect_message(fails("sky", {{"radiance", text("studio")}, {"file", text("a.exr")}}), "file");
    expect_message(fails("sky", {{"cie", number(0)}}), "between 1 and 15");
    expect_message(fails("sky", {{"cie", number(2.5)}}), "whole number");
    expect_message(fails("sky", {{"cie", number(3)}, {"elevation", number(91)}}), "between 0 and 90");
    expect_message(fails("sky", {{"cie", number(3)}, {"file", text("a.exr")}}), "file");
    expect_message(fails("sky", {{"cie", number(3)}, {"radiance", text("studio")}}), "cie");
    expect_message(fails("sky", {{"elevation", number(30)}}), "elevation");
}

TEST(LightParameters, HaveGoodDefaults) {
    EXPECT_TRUE(make_light("point_light")->casts_shadows());
    EXPECT_FALSE(make_light("point_light", {{"shadows", truth(false)}})->casts_shadows());
    EXPECT_TRUE(make_light("area_light", {{"size", list({1, 1})}})->shape());
    EXPECT_EQ(make_light("sky")->escaped({0, 0, 1}), Rgb(1));
    EXPECT_FALSE(make_light("sun", {{"direction", list({0, 0, -1})}})->sample({}, {}).delta);
    EXPECT_EQ(fails("sun", {{"direction", list({0, 0, -1e-200})}}), "");
}

TEST(BuiltInLights, HaveNamesHelpAndDistinctParameters) {
    std::set<std::string> names;
    for (const LightKind& kind : shaders::builtin_lights()) {
        EXPECT_TRUE(names.insert(kind.name).second);
        EXPECT_GT(std::string(kind.help).size(), 5U);
        std::set<std::string> params;
        for (const ParamSpec& spec : kind.params) EXPECT_TRUE(params.insert(spec.name).second);
    }
    EXPECT_EQ(names.size(), 7U);
}

}  // namespace
}  // namespace cardioid::test

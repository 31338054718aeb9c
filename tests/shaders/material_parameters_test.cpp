#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "make.hpp"

#include "shaders/materials/metals.hpp"

namespace cardioid::test {
namespace {

std::string fails(const char* kind, const Values& values) {
    return error_of([&] { make_shader(kind, values); });
}

void expect_message(const std::string& got, const std::string& part) {
    EXPECT_NE(got.find("scene.csg:3:7"), std::string::npos) << got;
    EXPECT_NE(got.find(part), std::string::npos) << got;
}

TEST(MaterialParameters, OfWrongValuesAreRefusedWithTheirPlace) {
    const double nan = std::nan("");
    expect_message(fails("diffuse", {{"reflectance", number(1.5)}}), "reflectance = 1.5 must be between 0 and 1");
    expect_message(fails("diffuse", {{"reflectance", list({0.5, -0.1, 0})}}), "between 0 and 1");
    expect_message(fails("diffuse", {{"reflectance", number(nan)}}), "finite");
    expect_message(fails("diffuse", {{"reflectance", text("red")}}), "a colour");
    expect_message(fails("diffuse", {{"reflectance", list({1, 1})}}), "a colour");
    expect_message(fails("phong", {{"diffuse", number(0.7)}, {"specular", number(0.4)}}), "at most 1");
    expect_message(fails("phong", {{"diffuse", number(0.9)}}), "at most 1");
    expect_message(fails("phong", {{"exponent", number(-1)}}), "between 0 and");
    expect_message(fails("phong", {{"attenuation", list({0, 0, 0})}}), "not all 0");
    expect_message(fails("phong", {{"attenuation", list({1, -1, 1})}}), "none negative");
    expect_message(fails("phong", {{"attenuation", list({1, 1, 1})}, {"attenuation_p", number(1)}}), "left out");
    expect_message(fails("plastic", {{"ior", number(0.9)}}), "between 1 and 4");
    expect_message(fails("plastic", {{"roughness", number(2)}}), "between 0 and 1");
    expect_message(fails("conductor", {{"metal", text("glod")}}), "did you mean \"gold\"?");
    expect_message(fails("conductor", {{"metal", text("adamantium-plated")}}), "one of aluminium, chromium");
    expect_message(fails("conductor", {{"metal", number(3)}}), "a text");
    expect_message(fails("conductor", {{"eta", number(1)}}), "k must be given");
    expect_message(fails("conductor", {{"eta", number(0)}, {"k", number(1)}}), "above 0");
    expect_message(fails("conductor", {{"eta", number(1)}, {"k", number(1)}, {"metal", text("gold")}}), "left out");
    expect_message(fails("dielectric", {{"ior", number(0.5)}}), "between 1 and 10");
    expect_message(fails("dielectric", {{"absorption", number(-1)}}), "at least 0");
    expect_message(fails("dielectric", {{"transmittance", number(0)}}), "above 0");
    expect_message(fails("dielectric", {{"transmittance", number(0.5)}, {"distance", number(0)}}), "above 0");
    expect_message(fails("dielectric", {{"transmittance", number(0.5)}, {"absorption", number(1)}}), "left out");
    expect_message(fails("dielectric", {{"distance", number(2)}}), "together with transmittance");
    expect_message(fails("dielectric", {{"priority", number(0.5)}}), "a whole number");
    expect_message(fails("checker", {{"size", number(0)}}), "above 0");
    expect_message(fails("filter", {{"transmittance", number(2)}}), "between 0 and 1");
}

TEST(MaterialParameters, AllHaveDefaults) {
    for (const ShaderKind& kind : shaders::builtin_shaders()) EXPECT_NE(make_shader(kind.name), nullptr) << kind.name;
}

TEST(BuiltInMaterials, HaveNamesHelpAndDistinctParameters) {
    std::set<std::string> names;
    for (const ShaderKind& kind : shaders::builtin_shaders()) {
        EXPECT_TRUE(names.insert(kind.name).second);
        EXPECT_GT(std::string(kind.help).size(), 5U);
        std::set<std::string> params;
        for (const ParamSpec& spec : kind.params) EXPECT_TRUE(params.insert(spec.name).second);
    }
    EXPECT_EQ(names.size(), 10U);
}

TEST(Metals, AllHaveNamesThatAreFound) {
    for (const shaders::Metal& metal : shaders::metals()) {
        EXPECT_EQ(shaders::find_metal(metal.name), &metal);
        EXPECT_GT(min_component(metal.eta), 0);
    }
    EXPECT_EQ(shaders::find_metal("aluminum"), shaders::find_metal("aluminium"));
    EXPECT_EQ(shaders::find_metal("Gold"), nullptr);
}

}  // namespace
}  // namespace cardioid::test

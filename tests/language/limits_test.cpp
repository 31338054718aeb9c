#include "formats/openscad/limits.hpp"

#include <gtest/gtest.h>

#include "tests/language/read.hpp"

namespace cardioid::test {
namespace {

ReadOptions with(const std::string& name, const std::string& value) {
    ReadOptions options;
    options.settings = {{name, value}};
    return options;
}

TEST(Limits, AreRaisedAndLoweredByTheirNames) {
    EXPECT_EQ(formats::openscad::limits_of(with("minkowski", "1e9")).minkowski, 1e9);
    EXPECT_EQ(formats::openscad::limits_of(with("triangles", "12")).triangles, 12);
    EXPECT_EQ(formats::openscad::limits_of(with("cells", "12")).cells, 12);
    EXPECT_EQ(formats::openscad::limits_of(with("nesting", "12")).nesting, 12U);
    EXPECT_EQ(formats::openscad::limits_of({}).nesting, 100'000U);
}

TEST(Limits, OfUnknownNamesAndValuesAreRefused) {
    EXPECT_NE(error_of("cube();", with("minkovski", "1")).find("did you mean \"minkowski\"?"), std::string::npos);
    for (const char* value : {"", "x", "0", "-1", "nan", "inf", "1e99", "5 "})
        EXPECT_NE(error_of("cube();", with("cells", value)).find("wanted a number from 1"), std::string::npos) << value;
}

TEST(Limits, HoldForExtrusionsAndNesting) {
    const std::string twisted = "linear_extrude(height = 1, twist = 90, slices = 100) square(1);";
    EXPECT_NE(error_of(twisted, with("triangles", "500")).find("--set csg.triangles=800"), std::string::npos)
        << error_of(twisted, with("triangles", "500"));
    EXPECT_EQ(error_of(twisted, with("triangles", "1000")), "");
    const std::string deep = "group() { group() { group() { cube(); } } }";
    EXPECT_NE(error_of(deep, with("nesting", "2")).find("more than 2 calls"), std::string::npos);
    EXPECT_EQ(error_of(deep, with("nesting", "4")), "");
}

}  // namespace
}  // namespace cardioid::test

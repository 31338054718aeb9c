#include "rt_core/scene/nearest_name.hpp"

#include <gtest/gtest.h>

using namespace cardioid;

namespace {
constexpr std::string_view names[] = {"sphere", "square", "cylinder", "cube"};
}

TEST(NearestName, ForgivesAThirdOfTheLetters) {
    EXPECT_EQ(nearest_name("sphre", names), "sphere");
    EXPECT_EQ(nearest_name("shpere", names), "sphere");
    EXPECT_EQ(nearest_name("CYLINDRE", names), "cylinder");
    EXPECT_EQ(nearest_name("cub", names), "cube");
    EXPECT_EQ(nearest_name("cu", names), "");
    EXPECT_EQ(nearest_name("torus", names), "");
}

TEST(NearestName, TakesTheFirstOfEquallyNear) {
    static constexpr std::string_view twins[] = {"abcx", "abcy"};
    EXPECT_EQ(nearest_name("abcz", twins), "abcx");
}

TEST(NearestName, SaysNothingWhereNothingIsNear) {
    EXPECT_EQ(did_you_mean("qqqq", names), "");
    EXPECT_EQ(did_you_mean("sqare", names), " (did you mean \"square\"?)");
    EXPECT_EQ(nearest_name(std::string(100'000, 'a'), names), "");
    EXPECT_EQ(nearest_name("", names), "");
}

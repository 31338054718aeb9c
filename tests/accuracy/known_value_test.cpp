/// Every value of the table that is not too noisy, with a fixed seed: a t test, and that it would see an error of 2 %.
#include <gtest/gtest.h>

#include "tests/accuracy/formulas/formulas.hpp"
#include "tests/accuracy/lit_scene.hpp"
#include "tests/accuracy/measure.hpp"

namespace cardioid::test {
namespace {

struct Trial {
    std::string module;
    KnownValue known;
};

std::string name_of(const testing::TestParamInfo<Trial>& info) {
    return info.param.module + "_" + plain_name(info.param.known.title()) + "_" + std::to_string(info.index);
}

std::vector<Trial> trials() {
    std::vector<Trial> all;
    for (const std::string module : {"path"})
        for (const KnownValue& known : known_values(module, false)) all.push_back({module, known});
    return all;
}

class KnownValueTest : public testing::TestWithParam<Trial> {};

TEST_P(KnownValueTest, IsFound) {
    constexpr double least_p = 1e-4;
    const KnownValue& known = GetParam().known;
    const Measured found = measure(known, GetParam().module, {.noise = 0.0024, .most_samples = 1 << 22});
    EXPECT_EQ(found.bad_samples, 0U);
    if (known.expected == 0) {
        EXPECT_EQ(found.value, 0) << known.title();
        return;
    }
    EXPECT_GT(found.p_value(known.expected), least_p) << known.title() << ": found " << found.value << " +- "
                                                      << found.standard_error << ", wanted " << known.expected;
    EXPECT_LT(found.p_value(known.expected * 1.02), least_p) << "an error of 2 % would not be seen";
    EXPECT_LT(found.p_value(known.expected * 0.98), least_p) << "an error of 2 % would not be seen";
}

INSTANTIATE_TEST_SUITE_P(Table, KnownValueTest, testing::ValuesIn(trials()), name_of);

}  // namespace
}  // namespace cardioid::test

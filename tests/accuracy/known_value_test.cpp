/// Values of the table that are not too noisy, with a fixed seed: a t test, and that it would see an error of 2 %.
#include "tests/accuracy/expect_found.hpp"

namespace cardioid::test {
namespace {

/// A lighting module and the settings of one scene file.
struct Trial {
    std::string module;
    std::vector<Setting> settings;
};

std::string name_of(const testing::TestParamInfo<Trial>& info) {
    const KnownValue& first = info.param.settings.front().front();
    return info.param.module + "_" + plain_name(first.section + " " + first.scene) + std::to_string(info.index);
}

std::vector<Trial> trials() {
    std::vector<Trial> all;
    for (const std::string module : {"path", "photon"})
        for (const Setting& setting : known_settings(module, Run::quick)) {
            const std::string& scene = setting.front().scene;
            if (all.empty() || all.back().module != module || all.back().settings.front().front().scene != scene)
                all.push_back({module, {}});
            all.back().settings.push_back(setting);
        }
    return all;
}

class KnownValueTest : public testing::TestWithParam<Trial> {};

TEST_P(KnownValueTest, IsFound) {
    const std::string& module = GetParam().module;
    const bool exact = module == "path";
    const Effort effort{.noise = exact ? 0.0028 : 0.0018, .most_samples = exact ? 1U << 22 : 1U << 18};
    Params options("test");
    if (module == "photon") options.set("count", 4e5), options.set("caustic_count", 2e5);
    for (const Setting& setting : GetParam().settings) {
        Bench bench(setting.front(), module, 1, options);
        for (const KnownValue& known : setting) expect_found(known, bench, effort, exact ? 0 : known.tolerance(module));
    }
}

INSTANTIATE_TEST_SUITE_P(Table, KnownValueTest, testing::ValuesIn(trials()), name_of);

}  // namespace
}  // namespace cardioid::test

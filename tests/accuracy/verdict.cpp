#include "tests/accuracy/verdict.hpp"

#include <cmath>

namespace cardioid::test {

std::vector<Verdict> judge(const Setting& setting, const std::string& module) {
    constexpr std::uint64_t most_samples = 1 << 23;
    constexpr std::uint32_t most_runs = 32, first_seed = 1001;
    Params options("test");
    if (module == "photon") options.set("error", 0.01);  // as `cardioid probe --noise 0.2%` does
    std::vector<Verdict> verdicts;
    Bench bench(setting.front(), module, first_seed, options);
    for (const KnownValue& known : setting) {
        const double tolerance = known.tolerance(module);
        // A sixth of the tolerance is aimed at, and a third is enough where that takes too long.
        const double noise = tolerance / 6;
        Verdict verdict{.found = bench.measure(known, {noise, most_samples, most_runs})};
        const double scale = known.expected == 0 ? 1 : std::abs(known.expected);
        verdict.error = (verdict.found.value - known.expected) / scale;
        verdict.standard_error = verdict.found.standard_error / scale;
        verdict.sure = 3 * verdict.standard_error < tolerance;
        verdict.right = std::abs(verdict.error) <= tolerance;
        verdicts.push_back(verdict);
    }
    const double share_s = bench.prepared_s() / static_cast<double>(setting.size());
    for (Verdict& verdict : verdicts) verdict.found.cpu_s += share_s;
    return verdicts;
}

}  // namespace cardioid::test

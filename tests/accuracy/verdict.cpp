#include "tests/accuracy/verdict.hpp"

#include <cmath>

namespace cardioid::test {

namespace {

constexpr std::uint64_t most_samples = 1 << 23;
constexpr std::uint32_t most_runs = 32;

}  // namespace

std::vector<Verdict> judge(const Setting& setting, const std::string& module) {
    constexpr std::uint32_t first_seed = 1001;
    Params options("test");
    if (module == "photon") options.set("error", 0.01);  // as `cardioid probe --noise 0.2%` does
    std::vector<Verdict> verdicts;
    Bench bench(setting.front(), module, first_seed, options);
    for (const KnownValue& known : setting) {
        // A sixth of the tolerance is aimed at, and a third is enough where that takes too long.
        const double noise = known.tolerance(module) / 6;
        verdicts.push_back(verdict_of(known, module, bench.measure(known, {noise, most_samples, most_runs})));
    }
    const double share_s = bench.prepared_s() / static_cast<double>(setting.size());
    for (Verdict& verdict : verdicts) verdict.found.cpu_s += share_s;
    return verdicts;
}

Verdict verdict_of(const KnownValue& known, const std::string& module, const Measured& found) {
    const double tolerance = known.tolerance(module);
    const double scale = known.expected == 0 ? 1 : std::abs(known.expected);
    Verdict verdict{.found = found};
    verdict.error = (found.value - known.expected) / scale;
    verdict.standard_error = found.standard_error / scale;
    verdict.sure = 3 * verdict.standard_error < tolerance;
    verdict.right = std::abs(verdict.error) <= tolerance;
    return verdict;
}

bool as_long_as_allowed(const Measured& found, const std::string& module) {
    // Runs share the samples evenly, so that a few may be left over.
    return module == "path" ? found.samples + most_runs >= most_samples : found.runs >= static_cast<int>(most_runs);
}

}  // namespace cardioid::test

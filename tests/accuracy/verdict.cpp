#include "tests/accuracy/verdict.hpp"

#include <cmath>

namespace cardioid::test {

Verdict judge(const KnownValue& known, const std::string& module) {
    // A little more than is needed, as the next run's spread is another.
    const Effort effort{.noise = 0.9 * known.tolerance / 9, .most_samples = 1 << 28, .first_seed = 1001};
    Verdict verdict{.found = measure(known, module, effort)};
    const double scale = known.expected == 0 ? 1 : std::abs(known.expected);
    verdict.error = (verdict.found.value - known.expected) / scale;
    verdict.standard_error = verdict.found.standard_error / scale;
    verdict.sure = 9 * verdict.standard_error < known.tolerance;
    verdict.right = std::abs(verdict.error) <= known.tolerance + 3 * verdict.standard_error;
    return verdict;
}

}  // namespace cardioid::test

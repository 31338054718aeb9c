#pragma once
#include "tests/accuracy/measure.hpp"

namespace cardioid::test {

/// What the long run makes of a value: off by no more than its tolerance, and known well enough to say so.
struct Verdict {
    Measured found;
    double error = 0;           ///< found against expected, relative; the difference where 0 is expected
    double standard_error = 0;  ///< in the same terms
    bool sure = false;          ///< 3 standard errors are less than a third of the tolerance
    bool right = false;         ///< |error| <= tolerance + 3 standard errors
    [[nodiscard]] bool good() const { return sure && right; }
};

/// Measures until it is sure, or has drawn as many samples as is reasonable.
Verdict judge(const KnownValue& known, const std::string& module);

}  // namespace cardioid::test

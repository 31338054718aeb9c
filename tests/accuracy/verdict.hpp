#pragma once
#include "tests/accuracy/measure.hpp"

namespace cardioid::test {

/// What the long run makes of a value: off by no more than its tolerance, and known well enough to say so.
struct Verdict {
    Measured found;
    double error = 0;           ///< found against expected, relative; the difference where 0 is expected
    double standard_error = 0;  ///< in the same terms
    bool sure = false;          ///< 3 standard errors are less than the tolerance
    bool right = false;         ///< |error| <= tolerance
    [[nodiscard]] bool good() const { return sure && right; }
};

/// Measures each value of a setting until it is sure, or has drawn as many samples as is reasonable. What a module
/// takes to prepare is shared out evenly among them.
std::vector<Verdict> judge(const Setting& setting, const std::string& module);

/// What is to be thought of a measurement.
Verdict verdict_of(const KnownValue& known, const std::string& module, const Measured& found);

/// Whether judge() would not have gone on, however unsure it was.
bool as_long_as_allowed(const Measured& found, const std::string& module);

}  // namespace cardioid::test

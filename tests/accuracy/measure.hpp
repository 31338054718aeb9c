#pragma once
#include <string>

#include "tests/accuracy/table.hpp"

namespace cardioid::test {

/// How long to measure.
struct Effort {
    double noise;                  ///< relative standard error to reach
    std::uint64_t most_samples;    ///< of all runs together
    std::uint32_t first_seed = 1;  ///< runs use this and the following seeds
};

/// The mean of independent runs, each with its own seed for the module and the probe.
struct Measured {
    double value = 0, standard_error = 0;
    int runs = 0;
    std::uint64_t samples = 0;  ///< of all runs together
    double cpu_s = 0;
    std::uint64_t bad_samples = 0;

    /// Probability that runs of mean `expected` differ from it so much or more: Student's t test.
    [[nodiscard]] double p_value(double expected) const;
};

/// Measures a known value by a lighting module. Runs are repeated from the beginning with more samples until their mean
/// is sure enough, so that the last ones are independent of when they were stopped.
Measured measure(const KnownValue& known, const std::string& module, const Effort& effort);

/// Probability of |t| or more for Student's distribution.
double student_p(double t, int degrees);

}  // namespace cardioid::test

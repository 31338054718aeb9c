#pragma once
#include <algorithm>
#include <gtest/gtest.h>

#include "tests/accuracy/measure.hpp"

namespace cardioid::test {

/// Probability of so large an error beyond what is allowed.
inline double p_beyond(const Measured& found, double expected, double allowed) {
    return found.p_value(std::clamp(found.value, expected * (1 - allowed), expected * (1 + allowed)));
}

/// Expects a value, but for a relative bias of what is allowed (0 for a path tracer), by a t test with p > 1e-4, and
/// that the same test would see an error of 2 % either way.
inline void expect_found(const KnownValue& known, Bench& bench, const Effort& effort, double allowed) {
    constexpr double least_p = 1e-4;
    SCOPED_TRACE(known.title());
    const Measured found = bench.measure(known, effort);
    EXPECT_EQ(found.bad_samples, 0U);
    if (known.expected == 0) {
        EXPECT_EQ(found.value, 0);
        return;
    }
    EXPECT_GT(p_beyond(found, known.expected, allowed), least_p)
        << "found " << found.value << " +- " << found.standard_error << ", wanted " << known.expected;
    for (const double off : {0.98 * (1 - allowed), 1.02 * (1 + allowed)})
        EXPECT_LT(p_beyond(found, known.expected * off, allowed), least_p)
            << "an error of 2 % would not be seen; found " << found.value << " +- " << found.standard_error;
}

}  // namespace cardioid::test

#pragma once
#include <cmath>
#include <vector>

namespace cardioid::photon::test {

/// Mean and spread of independent numbers.
class Moments {
public:
    void add(double x) {
        ++n_;
        const double step = x - mean_;
        mean_ += step / n_;
        squares_ += step * (x - mean_);
    }
    [[nodiscard]] double mean() const { return mean_; }
    [[nodiscard]] double deviation() const { return std::sqrt(squares_ / (n_ - 1)); }
    [[nodiscard]] double standard_error() const { return deviation() / std::sqrt(n_); }
    /// Probability of a mean this far from `expected` or farther (two sides; n is large enough for the normal law).
    [[nodiscard]] double p_value(double expected) const {
        return std::erfc(std::abs(mean_ - expected) / standard_error() / std::sqrt(2.0));
    }

private:
    double n_ = 0, mean_ = 0, squares_ = 0;
};

}  // namespace cardioid::photon::test

#pragma once
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "rt_core/api/math.hpp"

namespace cardioid::test {

/// Random numbers in [0, 1) that are independent of the program's own sampler.
class Random {
public:
    explicit Random(std::uint32_t seed = 1) : bits_(seed) {}
    float next() { return unit_float(static_cast<std::uint32_t>(bits_())); }
    Vec2 next2() {
        const float x = next();
        return {x, next()};
    }
    /// A direction of the sphere, uniformly.
    Vec3 direction() { return sample_sphere(next2()); }

private:
    std::mt19937 bits_;
};

/// Probability that chi-squared of that many degrees of freedom is larger: the upper regularised gamma function.
double chi_squared_p(double chi_squared, double degrees);

/// Draws a direction; nothing drawn is the zero vector.
using Draw = std::function<Vec3(Random&)>;
/// Density [1/sr] of those directions.
using Density = std::function<double(Vec3)>;

/// Where directions are counted: a cone about `axis` down to cosine z_min, in equal cells.
struct Bins {
    Frame axis;
    double z_min = -1;
    int rows = 8, columns = 12;
};

/// Histogram of n draws against the density integrated over each cell (by stratified points); what falls outside, or is
/// not drawn, is one more cell.
class DirectionTest {
public:
    DirectionTest(const Draw& draw, const Density& density, int n, const Bins& bins = {});
    /// p-value of the histogram for the density times `scale`.
    [[nodiscard]] double p_value(double scale = 1) const;
    /// Integral of the density over the cone.
    [[nodiscard]] double integral() const;

private:
    std::vector<double> counts_, shares_;
    double outside_ = 0;
    int n_;
};

/// What a test of density against draws expects: agreement, and that an error of 2 % would be seen.
void expect_density(const Draw& draw, const Density& density, const Bins& bins = {}, int n = 300'000);

}  // namespace cardioid::test

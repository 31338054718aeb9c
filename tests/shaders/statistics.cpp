#include "statistics.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace cardioid::test {

double chi_squared_p(double chi_squared, double degrees) {
    const double a = degrees / 2, x = chi_squared / 2;
    if (x <= 0) return 1;
    const double front = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x < a + 1) {  // series of the lower function
        double term = 1 / a, sum = term;
        for (double k = a + 1; term > sum * 1e-15; ++k) sum += term *= x / k;
        return 1 - front * sum;
    }
    // continued fraction of the upper one, from the far end
    double fraction = 0;
    for (int k = 500; k >= 1; --k) fraction = k * (k - a) / (x + 2 * k + 1 - a - fraction);
    return front / (x + 1 - a - fraction);
}

DirectionTest::DirectionTest(const Draw& draw, const Density& density, int n, const Bins& bins)
    : counts_(static_cast<std::size_t>(bins.rows * bins.columns)), shares_(counts_.size()), n_(n) {
    Random random;
    const double height = (1 - bins.z_min) / bins.rows, width = 2 * std::numbers::pi / bins.columns;
    for (int i = 0; i < n; ++i) {
        const Vec3 d = bins.axis.to_local(draw(random));
        const double flat = double{d.x} * double{d.x} + double{d.y} * double{d.y}, z = double{d.z};
        const double drop = z > 0 ? flat / (1 + z) : 1 - z;  // 1 - cos, with all its digits for narrow cones
        const int row = d == Vec3{} ? -1 : bins.rows - 1 - static_cast<int>(drop / height);
        double phi = std::atan2(double{d.y}, double{d.x});
        if (phi < 0) phi += 2 * std::numbers::pi;
        const int column = std::min(static_cast<int>(phi / width), bins.columns - 1);
        if (row < 0)
            ++outside_;
        else
            ++counts_[static_cast<std::size_t>(row * bins.columns + column)];
    }
    Random jitter(2);  // lamps have edges that lie along rows of points
    const auto integrate = [&](int bin, int steps) {
        double sum = 0, least = HUGE_VAL, most = 0;
        for (int i = 0; i < steps * steps; ++i) {
            const double row = bin / bins.columns + (i / steps + double{jitter.next()}) / steps;
            const double column = bin % bins.columns + (i % steps + double{jitter.next()}) / steps;
            const double z = bins.z_min + row * height, r = std::sqrt(1 - z * z);
            const Vec3d local{r * std::cos(column * width), r * std::sin(column * width), z};
            const double value = density(bins.axis.to_world(Vec3(local)));
            sum += value, least = std::min(least, value), most = std::max(most, value);
        }
        const int needed = most > 20 * least ? 200 : most > 1.5 * least ? 64 : 0;
        return std::pair(sum * height * width / (steps * steps), needed);
    };
    for (std::size_t bin = 0; bin < shares_.size(); ++bin) {
        const auto [coarse, needed] = integrate(static_cast<int>(bin), 16);
        shares_[bin] = needed > 0 ? integrate(static_cast<int>(bin), needed).first : coarse;
    }
}

double DirectionTest::integral() const {
    double sum = 0;
    for (const double share : shares_) sum += share;
    return sum;
}

double DirectionTest::p_value(double scale) const {
    constexpr double least = 60;  // cells that expect fewer are taken together
    double chi = 0, few_count = outside_, few_expected = std::max(0.0, 1 - integral() * scale) * n_;
    int cells = 0;
    const auto add = [&](double count, double expected) {
        chi += (count - expected) * (count - expected) / expected;
        ++cells;
    };
    for (std::size_t i = 0; i < shares_.size(); ++i) {
        const double expected = shares_[i] * scale * n_;
        if (expected >= least)
            add(counts_[i], expected);
        else
            few_count += counts_[i], few_expected += expected;
    }
    if (few_expected >= least)
        add(few_count, few_expected);
    else if (few_count > least + 10 * std::sqrt(least))
        return 0;
    return chi_squared_p(chi, std::max(1, cells - 1));
}

void expect_density(const Draw& draw, const Density& density, const Bins& bins, int n) {
    const DirectionTest test(draw, density, n, bins);
    EXPECT_GT(test.p_value(), 1e-4) << "integral of the density " << test.integral();
    EXPECT_LT(test.p_value(1.02), 1e-4);
    EXPECT_LT(test.p_value(0.98), 1e-4);
}

}  // namespace cardioid::test

#include <gtest/gtest.h>

#include "rt_core/math/sampler.hpp"
#include "rt_core/render/sampling/pixel_filter.hpp"

namespace cardioid {
namespace {

constexpr int n = 1 << 16;

/// Mean of x, of x^2 + y^2, and the largest radius.
struct Spread {
    double mean = 0, square = 0, reach = 0;
};

Spread spread_of(Vec2d (*filter)(Vec2)) {
    Spread s;
    for (std::uint32_t i = 0; i < n; ++i) {
        Sampler sampler(1, Purpose::test, 0, i);
        const Vec2d p = filter(sampler.next2());
        s.mean += p.x / n;
        s.square += dot(p, p) / n;
        s.reach = std::max(s.reach, length(p));
    }
    return s;
}

TEST(PixelFilter, GaussianHasTheMomentsOfItsTruncatedDensity) {
    const Spread s = spread_of(sample_gaussian_filter);
    // E[r^2] = 2 sigma^2 (1 - a e^-a / (1 - e^-a)) with a = R^2 / (2 sigma^2) = 4.5, sigma = 0.5.
    const double a = 4.5, wanted = 0.5 * (1 - a * std::exp(-a) / (1 - std::exp(-a)));
    EXPECT_NEAR(s.mean, 0, 1e-3);
    EXPECT_NEAR(s.square, wanted, 1e-3);
    EXPECT_LE(s.reach, gaussian_reach);
    EXPECT_GT(s.reach, 0.99 * gaussian_reach);
}

TEST(PixelFilter, BoxFillsItsPixel) {
    const Spread s = spread_of(sample_box_filter);
    EXPECT_NEAR(s.mean, 0, 1e-3);
    EXPECT_NEAR(s.square, 1.0 / 6, 1e-3);
    EXPECT_LE(s.reach, std::sqrt(0.5));
}

}  // namespace
}  // namespace cardioid

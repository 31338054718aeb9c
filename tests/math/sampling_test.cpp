#include "rt_core/math/sampling.hpp"

#include <gtest/gtest.h>
#include <random>

#include "rt_core/math/frame.hpp"
#include "rt_core/math/sampler.hpp"

namespace cardioid {
namespace {

/// Mean and its standard error of f(u) for 200,000 independent pairs of numbers.
struct Mean {
    double value, error;
    template <class F>
    explicit Mean(F&& f) {
        std::mt19937 bits(1);
        constexpr int n = 200'000;
        double sum = 0, squares = 0;
        for (int i = 0; i < n; ++i) {
            const float x = unit_float(static_cast<std::uint32_t>(bits()));
            const double v = double{f(Vec2{x, unit_float(static_cast<std::uint32_t>(bits()))})};
            sum += v, squares += v * v;
        }
        value = sum / n;
        error = std::sqrt((squares / n - value * value) / n);
    }
};

/// Within four standard errors (p = 6e-5), and 2 % off would not be.
void expect_mean(const Mean& mean, double wanted) {
    EXPECT_NEAR(mean.value, wanted, 4 * mean.error + 1e-6);
    EXPECT_GT(std::abs(mean.value - 1.02 * wanted), 4 * mean.error + 1e-6);
}

TEST(Sampling, OfTheDiscIsEven) {
    expect_mean(Mean([](Vec2 u) { return dot(sample_disc(u), sample_disc(u)); }), 0.5);
    expect_mean(Mean([](Vec2 u) { return length(sample_disc(u)) < 0.5F ? 1.0F : 0.0F; }), 0.25);
    EXPECT_NEAR(Mean([](Vec2 u) { return sample_disc(u).x; }).value, 0, 5e-3);
    EXPECT_EQ(sample_disc({0.5F, 0.5F}), (Vec2{0, 0}));
}

TEST(Sampling, OfTheHemisphereFollowsTheCosine) {
    expect_mean(Mean([](Vec2 u) { return sample_cosine_hemisphere(u).z; }), 2.0 / 3);
    // A quarter of Lambert's light leaves beyond 60 degrees.
    expect_mean(Mean([](Vec2 u) { return sample_cosine_hemisphere(u).z < 0.5F ? 1.0F : 0.0F; }), 0.25);
    EXPECT_NEAR(Mean([](Vec2 u) { return sample_cosine_hemisphere(u).y; }).value, 0, 5e-3);
}

TEST(Sampling, OfTheSphereIsEven) {
    for (int axis = 0; axis < 3; ++axis) {
        expect_mean(Mean([axis](Vec2 u) { return sample_sphere(u)[axis] * sample_sphere(u)[axis]; }), 1.0 / 3);
        EXPECT_NEAR(Mean([axis](Vec2 u) { return sample_sphere(u)[axis]; }).value, 0, 6e-3);
    }
}

TEST(Sampling, FillsEightHundredEqualCellsOfTheSphereEvenly) {
    std::mt19937 bits(1);
    std::vector<double> cells(800);
    constexpr int n = 800'000;
    for (int i = 0; i < n; ++i) {
        const float x = unit_float(static_cast<std::uint32_t>(bits()));
        const Vec3 d = sample_sphere({x, unit_float(static_cast<std::uint32_t>(bits()))});
        const int row = std::min(static_cast<int>((d.z + 1) * 10), 19);
        const int column = std::min(static_cast<int>((std::atan2(d.y, d.x) + pi) / (2 * pi) * 40), 39);
        ++cells[static_cast<std::size_t>(row * 40 + column)];
    }
    double chi = 0;
    for (const double count : cells) chi += (count - n / 800) * (count - n / 800) / (n / 800);
    EXPECT_NEAR(chi, 799, 4 * std::sqrt(2 * 799.0));
}

TEST(Sampling, OfAConeStaysInsideAndIsEven) {
    for (const float one_minus_cos : {1e-9F, 1e-5F, 0.3F, 2.0F}) {
        // Of a cone, 1 - cos is even; from x and y, which keep their digits in narrow ones.
        const auto drop = [&](Vec2 u) {
            const Vec3 d = sample_cone(u, one_minus_cos);
            const float flat = d.x * d.x + d.y * d.y;
            const float value = d.z > 0 ? flat / (1 + d.z) : 1 - d.z;
            EXPECT_LE(value, one_minus_cos * (1 + 1e-5F));
            return value / one_minus_cos;
        };
        expect_mean(Mean(drop), 0.5);
    }
}

TEST(Sampling, GivesUnitDirectionsForEveryNumber) {
    constexpr float edge = 0x1.fffffep-1F;
    for (const float x : {0.0F, 0x1p-24F, 0.5F, edge})
        for (const float y : {0.0F, 0x1p-24F, 0.5F, edge})
            for (const Vec3 d : {sample_sphere({x, y}), sample_cosine_hemisphere({x, y}), sample_cone({x, y}, 0.1F)}) {
                EXPECT_NEAR(length(d), 1, 1e-6F);
                EXPECT_TRUE(is_finite(d));
            }
}

TEST(PowerHeuristic, SharesAllAndPrefersTheDenser) {
    for (const float a : {0.1F, 1.0F, 30.0F})
        for (const float b : {0.2F, 5.0F}) EXPECT_NEAR(power_heuristic(a, b) + power_heuristic(b, a), 1, 1e-6F);
    EXPECT_EQ(power_heuristic(2, 0), 1);
    EXPECT_EQ(power_heuristic(0, 0), 0);
    EXPECT_GT(power_heuristic(2, 1), 0.5F);
}

TEST(Sampling, HasTheSineAndCosineOfSmallAngles) {
    for (int i = -1000; i <= 1000; ++i) {
        const float a = static_cast<float>(i) * pi / 4000;
        const Vec2 found = sin_cos_of_eighth(a);
        EXPECT_NEAR(found.x, std::sin(static_cast<double>(a)), 1.5e-7);
        EXPECT_NEAR(found.y, std::cos(static_cast<double>(a)), 1.5e-7);
    }
}

}  // namespace
}  // namespace cardioid

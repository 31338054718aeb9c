#include "rt_core/math/sampler.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <vector>

namespace cardioid {
namespace {

TEST(Sampler, GivesTheSameNumbersAgain) {
    Sampler a(3, Purpose::camera, 17, 5), b(3, Purpose::camera, 17, 5);
    for (int i = 0; i < 50; ++i) EXPECT_EQ(a.next2(), b.next2());
}

TEST(Sampler, ChangesWithEverythingItDependsOn) {
    std::set<std::pair<float, float>> first;
    for (const Purpose purpose : {Purpose::camera, Purpose::photons})
        for (std::uint32_t seed = 0; seed < 3; ++seed)
            for (std::uint64_t index : {0ULL, 1ULL, 1ULL << 40})
                for (std::uint32_t sample = 0; sample < 3; ++sample) {
                    const Vec2 u = Sampler(seed, purpose, index, sample).next2();
                    EXPECT_TRUE(first.emplace(u.x, u.y).second);
                }
}

TEST(Sampler, StaysBelowOne) {
    EXPECT_LT(unit_float(0xFFFFFFFFU), 1);
    EXPECT_EQ(unit_float(0), 0);
    for (std::uint32_t i = 0; i < 20'000; ++i) {
        Sampler sampler(9, Purpose::test, i, i * 77);
        for (int d = 0; d < 3; ++d) {
            const Vec2 u = sampler.next2();
            ASSERT_TRUE(u.x >= 0 && u.x < 1 && u.y >= 0 && u.y < 1);
        }
    }
}

/// Points of consecutive samples in a pair of dimensions.
std::vector<Vec2> points(std::uint64_t index, int dimension, std::uint32_t n) {
    std::vector<Vec2> out;
    for (std::uint32_t i = 0; i < n; ++i) {
        Sampler sampler(1, Purpose::test, index, i);
        for (int d = 0; d < dimension; ++d) static_cast<void>(sampler.next2());
        out.push_back(sampler.next2());
    }
    return out;
}

TEST(Sampler, FillsEveryElementaryIntervalOnce) {
    // A (0, m, 2) net: 2^m points put one into every box of 2^-a by 2^-(m - a).
    constexpr int m = 8;
    for (const int dimension : {0, 1, 6})
        for (int a = 0; a <= m; ++a) {
            std::set<std::pair<int, int>> boxes;
            for (const Vec2 u : points(5, dimension, 1 << m))
                boxes.emplace(static_cast<int>(std::ldexp(u.x, a)), static_cast<int>(std::ldexp(u.y, m - a)));
            EXPECT_EQ(boxes.size(), std::size_t{1} << m) << "dimension " << dimension << ", a = " << a;
        }
}

TEST(Sampler, KeepsItsDimensionsAndIndicesIndependent) {
    const auto correlation = [](const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += (double{a[i].x} - 0.5) * (double{b[i].x} - 0.5);
        return sum * 12 / static_cast<double>(a.size());
    };
    constexpr std::uint32_t n = 4096;
    const double limit = 4 / std::sqrt(double{n});  // four standard deviations of independent numbers
    EXPECT_LT(std::abs(correlation(points(1, 0, n), points(1, 1, n))), limit);
    EXPECT_LT(std::abs(correlation(points(1, 2, n), points(1, 5, n))), limit);
    EXPECT_LT(std::abs(correlation(points(1, 0, n), points(2, 0, n))), limit);
    EXPECT_GT(correlation(points(1, 0, n), points(1, 0, n)), 0.9);  // the test sees what is not independent
}

TEST(Sampler, IsEvenAcrossPixels) {
    // The first sample of many pixels is as good as random: chi-squared of 64 cells, 63 degrees of freedom.
    std::vector<double> cells(64);
    constexpr int n = 64'000;
    for (std::uint64_t i = 0; i < n; ++i) {
        const Vec2 u = Sampler(0, Purpose::camera, i, 0).next2();
        ++cells[static_cast<std::size_t>(u.x * 8) * 8 + static_cast<std::size_t>(u.y * 8)];
    }
    double chi = 0;
    for (const double count : cells) chi += (count - n / 64) * (count - n / 64) / (n / 64);
    EXPECT_GT(chi, 25);   // p = 1 - 1e-5
    EXPECT_LT(chi, 115);  // p = 1e-4 is at 113.5
}

}  // namespace
}  // namespace cardioid

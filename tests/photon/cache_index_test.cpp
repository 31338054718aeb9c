#include "photon/cache/cache_index.hpp"

#include <gtest/gtest.h>
#include <random>
#include <set>

#include "photon/cache/neighbour_tree.hpp"

namespace cardioid::photon {
namespace {

/// Balls of very different sizes, some on top of each other.
std::vector<Reach> random_balls(std::size_t count, std::uint32_t seed) {
    std::mt19937 bits(seed);
    std::uniform_real_distribution<float> u(0, 1);
    std::vector<Reach> balls;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 n = sample_sphere({u(bits), u(bits)});
        Vec3 p{u(bits), u(bits), u(bits)};
        if (i % 7 == 3) p = balls.back().p;
        balls.push_back({p, n, 0.3F * std::pow(u(bits), 4.0F) + 1e-3F});
    }
    return balls;
}

/// The conditions as CacheIndex::around states them.
bool within(const Reach& ball, Vec3 p, Vec3 n, float turn) {
    const float t = length(p - ball.p) / ball.radius + std::sqrt(std::max(0.0F, 1 - dot(n, ball.n))) / turn;
    return t < 1 && std::abs(dot(p - ball.p, n + ball.n)) / 2 < 0.1F * ball.radius;
}

TEST(CacheIndex, FindsWhatBruteForceFinds) {
    constexpr float turn = 2;
    std::mt19937 bits(2);
    std::uniform_real_distribution<float> u(-0.1F, 1.1F);
    for (const std::size_t count : {0, 1, 9, 300, 2000}) {
        const std::vector<Reach> balls = random_balls(count, 5);
        const CacheIndex index(balls);
        std::size_t found = 0;
        for (int q = 0; q < 400; ++q) {
            const Vec3 p =
                q % 2 == 0 || balls.empty() ? Vec3{u(bits), u(bits), u(bits)} : balls[bits() % balls.size()].p;
            const Vec3 n = normalize(Vec3{u(bits), u(bits), u(bits)});
            std::set<std::uint32_t> got, wanted;
            index.around(p, n, turn, [&](std::uint32_t i, float t) {
                EXPECT_TRUE(t >= 0 && t < 1);
                EXPECT_TRUE(got.insert(i).second);
            });
            for (std::uint32_t i = 0; i < balls.size(); ++i)
                if (within(balls[i], p, n, turn)) wanted.insert(i);
            EXPECT_EQ(got, wanted);
            found += got.size();
        }
        EXPECT_EQ(found > 0, count > 0);
    }
}

TEST(NeighbourTree, FindsEveryBallThatOverlaps) {
    const std::vector<Reach> balls = random_balls(1000, 8);
    NeighbourTree tree({0, 0, 0}, 1);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        tree.add(balls[i].p, balls[i].radius);
        if (i % 50 != 49) continue;
        for (const Reach& ball : {balls[i / 2], balls[i]}) {
            std::set<std::size_t> got;
            tree.overlapping(ball.p, ball.radius, [&](std::uint32_t j) { EXPECT_TRUE(got.insert(j).second); });
            for (std::size_t j = 0; j <= i; ++j) {
                EXPECT_TRUE(got.count(j) || length(balls[j].p - ball.p) >= balls[j].radius + ball.radius) << j;
            }
            EXPECT_LT(got.size(), i + 2);
        }
    }
}

}  // namespace
}  // namespace cardioid::photon

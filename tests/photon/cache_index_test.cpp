#include "photon/cache/cache_index.hpp"

#include <gtest/gtest.h>
#include <random>
#include <set>

#include "photon/cache/cache_guess.hpp"
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

TEST(BallGroup, GivesTheSameBitsOnEveryProcessor) {
    const std::vector<Reach> balls = random_balls(800, 3);
    std::mt19937 bits(4);
    std::uniform_real_distribution<float> u(0, 1);
    unsigned found = 0;
    for (std::size_t first = 0; first < balls.size(); first += BallGroup::lanes) {
        BallGroup group{};
        for (std::size_t i = 0; i < BallGroup::lanes; ++i) {
            const Reach& ball = balls[first + i];
            group.x[i] = ball.p.x, group.y[i] = ball.p.y, group.z[i] = ball.p.z;
            group.nx[i] = ball.n.x, group.ny[i] = ball.n.y, group.nz[i] = ball.n.z;
            group.per_radius[i] = 1 / (20 * ball.radius);
        }
        const BallQuery query{{u(bits), u(bits), u(bits)}, balls[first].n, 0.5F};
        float plain[BallGroup::lanes], quick[BallGroup::lanes];
        const unsigned within = scan_balls_plain(group, query, plain);
        EXPECT_EQ(quickest_scan_balls()(group, query, quick), within);
        for (std::size_t i = 0; i < BallGroup::lanes; ++i) EXPECT_EQ(plain[i], quick[i]);
        found += within != 0;
    }
    EXPECT_GT(found, 10U);
}

TEST(CacheGuess, IsThatOfItsRecord) {
    std::mt19937 bits(6);
    std::uniform_real_distribution<float> u(-1, 1);
    const auto vector = [&] { return Vec3{u(bits), u(bits), u(bits)}; };
    unsigned clamped = 0;
    for (int i = 0; i < 100; ++i) {
        CacheRecord record;
        record.n = normalize(vector());
        record.E = {1 + u(bits), 1 + u(bits), 1 + u(bits)};
        record.rotational = {vector(), vector(), vector()};
        record.translational = {vector(), vector(), vector()};
        const Vec3 step = vector(), n = normalize(vector());
        const Rgb wanted = record.guess(step, n);
        GuessSum sum;
        sum.add(CacheGuess(record), step, n, 3);
        const Rgb got = sum.mean();
        EXPECT_NEAR(got.r, wanted.r, 1e-6);
        EXPECT_NEAR(got.g, wanted.g, 1e-6);
        EXPECT_NEAR(got.b, wanted.b, 1e-6);
        clamped += wanted.r == 0;
    }
    EXPECT_GT(clamped, 0U);
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

#include "photon/map/tree/scan.hpp"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>

#include "tests/photon_map/clouds.hpp"

namespace cardioid::photon::test {
namespace {

/// Places past the results may hold anything, and so may points outside of the bucket.
struct Results {
    std::uint32_t size = 0;
    std::vector<float> d2;
    std::vector<std::uint32_t> index;
    bool operator==(const Results& o) const {
        return size == o.size && std::memcmp(d2.data(), o.d2.data(), size * sizeof(float)) == 0 &&
               std::equal(index.begin(), index.begin() + size, o.index.begin());
    }
};

Results scan(const ScanKernels& kernels, std::span<const PointGroup> groups, Bucket bucket, const PointQuery& q) {
    Results r{0, std::vector<float>(100), std::vector<std::uint32_t>(100)};
    r.size =
        kernels.scan(groups.data(), bucket, ScanQuery(q), q.max_radius * q.max_radius, r.d2.data(), r.index.data());
    return r;
}

std::vector<PointGroup> random_groups(Random& random, std::size_t n) {
    std::vector<PointGroup> groups(n);
    for (PointGroup& g : groups)
        for (std::size_t i = 0; i < PointGroup::size; ++i) {
            g.x[i] = random.next(), g.y[i] = random.next(), g.z[i] = random.next();
            g.n[i] = encode_direction(sample_sphere(random.next2()));
            g.region[i] = random.below(2);
        }
    return groups;
}

PointQuery random_query(Random& random) {
    PointQuery q;
    q.p = random.next3();
    q.n = sample_sphere(random.next2());
    q.max_radius = random.next() * 1.5F;
    if (random.below(2)) q.least_cos = random.next();
    if (random.below(2)) q.region = random.below(2);
    if (random.below(2)) q.steepness = 2 * random.next(), q.slack = 0.1F * random.next();
    if (random.below(2)) q.flatten = 1 + 3 * random.next();
    return q;
}

TEST(ScanKernels, GiveTheSameBitsOnEveryProcessor) {
    Random random;
    for (int round = 0; round < 5'000; ++round) {
        const auto groups = random_groups(random, 4);
        const std::uint32_t first = random.below(32);
        const Bucket bucket{first, 1 + random.below(32)};
        const PointQuery q = random_query(random);
        const Results plain = scan(plain_kernels, groups, bucket, q);
        for (const ScanKernels& kernels : usable_kernels())
            ASSERT_EQ(scan(kernels, groups, bucket, q), plain) << kernels.name << ", round " << round;
    }
}

TEST(ScanKernels, EndWithThePlainOnes) {
    ASSERT_FALSE(usable_kernels().empty());
    EXPECT_STREQ(usable_kernels().back().name, "plain");
}

/// Distances as they come and as they should not: evenly, over many powers of two, few different ones, all the same.
float distance(Random& random, int kind) {
    switch (kind) {
        case 0:
            return random.next();
        case 1:
            return std::pow(10.0F, 60 * random.next() - 30);
        case 2:
            return static_cast<float>(random.below(4));
        default:
            return 0.5F;
    }
}

TEST(ScanKernels, KeepTheSmallestAndOfEqualOnesTheFirst) {
    Random random;
    for (int round = 0; round < 5'000; ++round) {
        const std::uint32_t n = 1 + random.below(random.below(100) == 0 ? 20'000 : 200), k = 1 + random.below(n);
        Results all{n, {}, {}};
        for (std::uint32_t i = 0; i < n; ++i) {
            all.d2.push_back(distance(random, round % 4));
            all.index.push_back(i);
        }
        all.d2.resize(n + 64), all.index.resize(n + 64);
        std::vector<std::uint32_t> order(all.index.begin(), all.index.begin() + n);
        std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return all.d2[i]; });
        std::sort(order.begin(), order.begin() + k);
        for (const ScanKernels& kernels : usable_kernels()) {
            Results got = all;
            const float largest = kernels.keep_smallest(got.d2.data(), got.index.data(), n, k);
            float expected = 0;
            // The last of the largest has changed places with the last of all.
            const auto last = std::max_element(
                got.index.begin(), got.index.begin() + k,
                [&](std::uint32_t a, std::uint32_t b) { return std::pair(all.d2[a], a) < std::pair(all.d2[b], b); });
            ASSERT_EQ(last - got.index.begin(), k - 1);
            const auto place = std::ranges::find(order, *last) - order.begin();
            std::swap(got.index[static_cast<std::size_t>(place)], got.index[k - 1]);
            std::swap(got.d2[static_cast<std::size_t>(place)], got.d2[k - 1]);
            for (std::uint32_t i = 0; i < k; ++i) {
                ASSERT_EQ(got.index[i], order[i]) << kernels.name << ", round " << round << ", " << k << " of " << n;
                ASSERT_EQ(got.d2[i], all.d2[order[i]]);
                expected = std::max(expected, all.d2[order[i]]);
            }
            ASSERT_EQ(largest, expected);
        }
    }
}

}  // namespace
}  // namespace cardioid::photon::test

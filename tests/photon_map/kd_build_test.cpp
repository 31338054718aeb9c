#include "photon/map/tree/kd_build.hpp"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <omp.h>

#include "rt_core/api/error.hpp"
#include "tests/photon_map/clouds.hpp"

namespace cardioid::photon::test {
namespace {

KdKey key(Vec3 p, std::uint32_t i) { return {{p.x, p.y, p.z}, i}; }

UntouchedVector<KdKey> keys_of(Cloud cloud, std::size_t n, std::uint32_t seed = 1) {
    Random random(seed);
    UntouchedVector<KdKey> keys(n);
    for (std::size_t i = 0; i < n; ++i) keys[i] = key(place(random, cloud), static_cast<std::uint32_t>(i));
    return keys;
}

struct Shape {
    int depth = 0;
    std::size_t points = 0;
};

/// Walks a tree and checks every node against the cell it stands in.
void check(const KdLayout& tree, std::size_t node, int depth, Vec3 lo, Vec3 hi, Shape& shape) {
    shape.depth = std::max(shape.depth, depth);
    const KdNode& at = tree.nodes[node];
    if (!at.is_bucket()) {
        Vec3 middle_hi = hi, middle_lo = lo;
        middle_hi[at.axis()] = middle_lo[at.axis()] = at.at();
        check(tree, node + 1, depth + 1, lo, middle_hi, shape);
        check(tree, node + at.right(), depth + 1, middle_lo, hi, shape);
        return;
    }
    const Bucket b = at.bucket();
    EXPECT_EQ(b.first, shape.points) << "buckets follow each other";
    EXPECT_GE(b.count, 1U);
    EXPECT_LE(b.count, 32U);
    shape.points += b.count;
    for (std::uint32_t i = b.first; i < b.first + b.count; ++i) {
        const Vec3 p = tree.keys[i].position();
        EXPECT_EQ(max(lo, min(hi, p)), p);
        EXPECT_TRUE(i == b.first || tree.keys[i - 1].index < tree.keys[i].index);
    }
}

Shape check(const KdLayout& tree) {
    Shape shape;
    check(tree, 0, 0, tree.lo, tree.hi, shape);
    return shape;
}

bool same(const KdLayout& a, const KdLayout& b) {
    return a.nodes.size() == b.nodes.size() &&
           std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(KdNode)) == 0 &&
           a.keys.size() == b.keys.size() &&
           std::memcmp(a.keys.data(), b.keys.data(), a.keys.size() * sizeof(KdKey)) == 0;
}

TEST(KdBuild, PutsEveryPointInItsCellAndNoMoreThanABucketfulTogether) {
    for (const Cloud cloud : all_clouds)
        for (const std::size_t n : {1U, 2U, 31U, 32U, 33U, 64U, 65U, 1000U, 70000U}) {
            const KdLayout tree = lay_out_kd(keys_of(cloud, n));
            EXPECT_EQ(check(tree).points, n);
            std::vector<bool> seen(n);
            for (const KdKey& key : tree.keys) seen[key.index] = true;
            EXPECT_EQ(std::count(seen.begin(), seen.end(), true), static_cast<std::ptrdiff_t>(n));
        }
}

TEST(KdBuild, IsNeverDeeperThanTheLogarithmOfItsPointsAndOne) {
    EXPECT_EQ(kd_depth_bound(1), 1);
    EXPECT_EQ(kd_depth_bound(1024), 11);
    EXPECT_EQ(kd_depth_bound(1025), 12);
    EXPECT_EQ(kd_depth_bound(1'000'000), 21);
    for (const Cloud cloud : all_clouds)
        for (const std::size_t n : {100U, 5000U}) {
            const KdLayout tree = lay_out_kd(keys_of(cloud, n));
            EXPECT_LE(check(tree).depth, kd_depth_bound(n));
        }
    // Each point a third as far from the corner as the one before: halving alone would be hundreds of levels deep.
    UntouchedVector<KdKey> keys(60);
    for (std::uint32_t i = 0; i < keys.size(); ++i) keys[i] = key({std::pow(3.0F, -static_cast<float>(i)), 0, 0}, i);
    EXPECT_LE(check(lay_out_kd(keys)).depth, kd_depth_bound(keys.size()));
}

TEST(KdBuild, IsTheSameForAnyNumberOfThreads) {
    const int before = omp_get_max_threads();
    for (const Cloud cloud : all_clouds) {
        omp_set_num_threads(1);
        const KdLayout alone = lay_out_kd(keys_of(cloud, 70'000));
        for (const int threads : {2, 7}) {
            omp_set_num_threads(threads);
            EXPECT_TRUE(same(alone, lay_out_kd(keys_of(cloud, 70'000))));
        }
    }
    omp_set_num_threads(before);
}

TEST(KdBuild, ChangesNothingInWhatIsLaidOutAlready) {
    for (const Cloud cloud : all_clouds) {
        KdLayout once = lay_out_kd(keys_of(cloud, 20'000));
        for (std::uint32_t i = 0; i < once.keys.size(); ++i) once.keys[i].index = i;
        EXPECT_TRUE(same(once, lay_out_kd(once.keys)));
    }
}

TEST(KdBuild, RefusesPlacesThatAreNotFinite) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        for (const int axis : {0, 1, 2}) {
            UntouchedVector<KdKey> keys = keys_of(Cloud::filled, 100);
            keys[57].p[axis] = bad;
            try {
                (void)lay_out_kd(keys);
                FAIL() << "was accepted";
            } catch (const Error& e) {
                EXPECT_EQ(e.code(), ErrorCode::bad_input);
                EXPECT_NE(std::string(e.what()).find("point 57 of 100"), std::string::npos) << e.what();
            }
        }
}

TEST(KdBuild, HasRoomForTheLargestNumbers) {
    constexpr float big = std::numeric_limits<float>::max();
    UntouchedVector<KdKey> keys(200);
    for (std::uint32_t i = 0; i < keys.size(); ++i) keys[i] = key({i % 2 ? big : -big, static_cast<float>(i), 0}, i);
    EXPECT_EQ(check(lay_out_kd(keys)).points, keys.size());
}

}  // namespace
}  // namespace cardioid::photon::test

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <span>

#include "photon/map/tree/point_tree.hpp"
#include "tests/photon_map/clouds.hpp"

namespace cardioid::photon::test {
namespace {

using Tree = PointTree<Photon>;
using Found = std::vector<std::pair<float, std::uint32_t>>;

/// Distance in the query's metric where the point passes its tests; in double, but for the distance itself.
std::optional<float> passes(const PointQuery& q, Vec3 p, Vec3 n, std::uint32_t region) {
    const Vec3 d = p - q.p;
    const float h = dot(d, q.n);
    const double height = std::abs(double{h});
    const double across = std::sqrt(std::max(0.0, double{dot(d, d)} - height * height));
    if (height > std::max(double{q.slack}, double{q.steepness} * across)) return {};
    const float d2 = q.flatten == 1 ? dot(d, d) : dot(d, d) + (q.flatten * q.flatten - 1) * (h * h);
    if (d2 > q.max_radius * q.max_radius) return {};
    if (q.least_cos >= 0 && double{dot(n, q.n)} < double{q.least_cos}) return {};
    const Vec3d sine = cross(Vec3d(n), Vec3d(q.n));
    const double bend = std::sqrt((4 * dot(sine, sine) + 4e-8) * double{dot(d, d)});
    if (q.least_cos >= 0 && !std::isinf(q.steepness) && height > std::max(double{q.slack}, bend)) return {};
    if (q.region != FaceId::none && region != q.region) return {};
    return d2;
}

Found brute_force(const Tree& tree, const PointQuery& q, std::uint32_t least_number = 0) {
    Found found;
    for (std::uint32_t i = 0; i < tree.size(); ++i)
        if (const auto d2 = passes(q, tree.position(i), decode_direction(tree.normal(i)), tree.region(i));
            d2 && tree.payload(i).flux >= least_number)
            found.emplace_back(*d2, i);
    std::ranges::sort(found);
    return found;
}

/// Whether the k first by brute force, up to the choice among equally far ones.
void expect_first(const Neighbours& got, const Found& all, std::uint32_t k) {
    ASSERT_EQ(got.size, std::min<std::size_t>(k, all.size()));
    Found sorted;
    for (std::uint32_t i = 0; i < got.size; ++i) sorted.emplace_back(got.d2[i], got.index[i]);
    std::ranges::sort(sorted);
    // One expectation for all of a cloud: there are millions of points.
    EXPECT_TRUE(sorted.empty() || got.d2[got.size - 1] == sorted.back().first) << "the farthest is the last";
    EXPECT_TRUE(std::ranges::equal(sorted, std::span(all).first(sorted.size()), {}, &Found::value_type::first,
                                   &Found::value_type::first))
        << "as far as those found by brute force";
    EXPECT_TRUE(std::ranges::includes(all, sorted)) << "they pass the tests";
    EXPECT_TRUE(std::ranges::adjacent_find(sorted) == sorted.end()) << "none is found twice";
}

PointQuery random_query(Random& random, Cloud cloud) {
    PointQuery q;
    q.p = random.below(3) == 0 ? random.next3() : place(random, cloud);
    q.n = sample_sphere(random.next2());
    if (random.below(2)) q.max_radius = 0.02F + random.next() * 0.5F;
    if (random.below(3) == 0) q.least_cos = random.next();
    if (random.below(3) == 0) q.region = random.below(4);
    if (random.below(3) == 0) q.steepness = 2 * random.next(), q.slack = 0.01F * random.next();
    if (random.below(3) == 0) q.flatten = 1 + 3 * random.next();
    return q;
}

/// Random clouds of every kind, a random query each.
template <class Check>
void for_clouds(std::uint32_t clouds, const Check& check) {
    Random random(7);
    for (std::uint32_t c = 0; c < clouds; ++c) {
        const Cloud cloud = all_clouds[c % std::size(all_clouds)];
        const std::uint32_t n = random.below(4) == 0 ? random.below(4) : random.below(300);
        Tree tree(cloud_of(cloud, n, c));
        check(tree, random_query(random, cloud), random);
        if (::testing::Test::HasFailure()) FAIL() << "cloud " << c << ", " << n << " points";
    }
}

TEST(KdTree, FindsTheNearestAsBruteForceDoesInTenThousandClouds) {
    for_clouds(10'000, [](const Tree& tree, const PointQuery& q, Random& random) {
        const std::uint32_t k = 1 + random.below(random.below(2) ? 10 : 400);
        Neighbours found;
        tree.nearest(q, k, found);
        expect_first(found, brute_force(tree, q), k);
    });
}

TEST(KdTree, FindsTheOneNearestAsBruteForceDoesInTenThousandClouds) {
    for_clouds(10'000, [](const Tree& tree, const PointQuery& q, Random& random) {
        const std::uint32_t least = random.below(100);
        const Nearest found =
            tree.nearest(q, [&](std::uint32_t i, float /*d2*/) { return tree.payload(i).flux >= least; });
        const Found all = brute_force(tree, q, least);
        ASSERT_EQ(found.found(), !all.empty());
        if (found.found()) {
            EXPECT_EQ(found.d2, all.front().first);
        }
    });
}

TEST(KdTree, FindsAllWithinARadiusAsBruteForceDoesInTenThousandClouds) {
    for_clouds(10'000, [](const Tree& tree, const PointQuery& q, Random&) {
        Found found;
        tree.visit_within(q, [&](std::uint32_t i, float d2) { found.emplace_back(d2, i); });
        std::ranges::sort(found);
        EXPECT_EQ(found, brute_force(tree, q));
    });
}

TEST(KdTree, AsksThePredicateBeforeAPointTakesAPlace) {
    for_clouds(2'000, [](const Tree& tree, const PointQuery& q, Random& random) {
        const std::uint32_t least = random.below(200), k = 1 + random.below(60);
        Neighbours found;
        tree.nearest(q, k, found, [&](std::uint32_t i, float) { return tree.payload(i).flux >= least; });
        expect_first(found, brute_force(tree, q, least), k);
    });
}

TEST(KdTree, FindsTheSameBitsOnEveryProcessor) {
    for_clouds(1'000, [](Tree& tree, const PointQuery& q, Random& random) {
        const std::uint32_t k = 1 + random.below(100);
        std::vector<Found> found;
        for (const ScanKernels& kernels : usable_kernels()) {
            tree.use(kernels);
            Neighbours nearest;
            tree.nearest(q, k, nearest);
            Found& all = found.emplace_back();
            for (std::uint32_t i = 0; i < nearest.size; ++i) all.emplace_back(nearest.d2[i], nearest.index[i]);
            const Nearest one = tree.nearest(q);
            all.emplace_back(one.d2, one.index);
            tree.visit_within(q, [&](std::uint32_t i, float d2) { all.emplace_back(d2, i); });
            EXPECT_EQ(all, found.front()) << kernels.name;
        }
    });
}

TEST(KdTree, WithoutPointsFindsNone) {
    const Tree tree, built{std::vector<Photon>()};
    for (const Tree* t : {&tree, &built}) {
        Neighbours found;
        t->nearest({}, 10, found);
        EXPECT_EQ(found.size, 0U);
        EXPECT_FALSE(t->nearest({}).found());
        t->visit_within({}, [](std::uint32_t, float) { ADD_FAILURE(); });
    }
}

TEST(KdTree, FindsNoneWhereNoneAreAskedFor) {
    const Tree tree(cloud_of(Cloud::filled, 100, 1));
    Neighbours found;
    tree.nearest({}, 0, found);
    EXPECT_EQ(found.size, 0U);
}

TEST(KdTree, CountsAPointAtExactlyTheRadius) {
    std::vector<Photon> one(1);
    one[0].p = {3, 4, 0};
    const Tree tree(one);
    EXPECT_TRUE(tree.nearest({.max_radius = 5}).found());
    EXPECT_FALSE(tree.nearest({.max_radius = std::nextafter(5.0F, 0.0F)}).found());
}

TEST(KdTree, GivesThePhotonsBackAsTheyWere) {
    const std::vector<Photon> photons = cloud_of(Cloud::walls, 1000, 3);
    const Tree tree(photons);
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        const Photon& was = photons[tree.payload(i).flux];
        EXPECT_EQ(tree.position(i), was.p);
        EXPECT_EQ(tree.normal(i), was.n);
        EXPECT_EQ(tree.region(i), was.region);
    }
}

}  // namespace
}  // namespace cardioid::photon::test

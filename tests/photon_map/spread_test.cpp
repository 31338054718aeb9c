#include "photon/map/spread.hpp"

#include <gtest/gtest.h>
#include <numbers>

#include "tests/photon_map/planes.hpp"

namespace cardioid::photon::test {
namespace {

constexpr Vec3 up{0, 0, 1};
using Light = double (*)(double, double);

LookupRule rule_of(std::uint32_t k) { return {.k = k, .spread = true, .kernel = Kernel::cone, .edge = EdgeRule::none}; }

/// Maps of the square [-half, half]^2 under light `f` in [0, 1], times `density` photons a unit of area.
PhotonMap map_of(std::uint32_t seed, double density, float half, Light f) {
    PhotonScene scene(seed);
    const auto at = [half](double u) { return (2 * u - 1) * double{half}; };
    scene.add({-half, -half, 0}, {2 * half, 0, 0}, {0, 2 * half, 0}, up, density,
              [&](double u, double v) { return f(at(u), at(v)); });
    return scene.map(density);
}

/// What lookups at the origin find in many maps, by photons spread over discs and by the discs of lookups.
struct Found {
    Moments spread, disc;
};
Found at_origin(std::uint32_t k, double density, float half, Light f) {
    Found found;
    LookupRule disc = rule_of(k);
    disc.spread = false;
    for (std::uint32_t i = 0; i < 50; ++i) {
        PhotonMap map = map_of(i, density, half, f);
        map.spread(rule_of(k));
        const SurfacePoint origin = point_at({}, up);
        found.spread.add(double{map.irradiance(origin, up, rule_of(k)).E.g});
        found.disc.add(double{map.irradiance(origin, up, disc).E.g});
    }
    return found;
}

double peak(double x, double y) { return std::exp(-(x * x + y * y) / 0.02); }

TEST(Spread, InEvenLightIsRight) {
    constexpr std::uint32_t k = 40;
    constexpr float side = 600;
    PhotonScene scene(1);
    scene.add({}, {side, 0, 0}, {0, side, 0}, up, 1);
    PhotonMap map = scene.map(1);
    map.spread(rule_of(k));
    Moments m;
    for (double x = 20; x < 580; x += 8)
        for (double y = 20; y < 580; y += 8) m.add(double{map.irradiance(point_at({x, y, 0}, up), up, rule_of(k)).E.g});
    EXPECT_GT(m.p_value(1), 1e-4) << m.mean() << " +- " << m.standard_error();
    EXPECT_LT(m.p_value(1.02), 1e-4) << "2 % would be seen";
    EXPECT_LT(m.deviation(), 1.3 * std::sqrt(1.5 / k));
}

TEST(Spread, KeepsTheFluxOfAPeakWhichDiscsOfLookupsDoNot) {
    constexpr std::uint32_t k = 100;
    PhotonMap map = map_of(1, 20'000, 0.6F, peak);
    map.spread(rule_of(k));
    LookupRule disc = rule_of(k);
    disc.spread = false;
    constexpr int rows = 200;
    double spread = 0, others = 0, flux = 0;
    for (std::uint32_t i = 0; i < map.size(); ++i) flux += double{map.flux(i).g};
    for (int i = 0; i < rows * rows; ++i) {
        const double step = 2.4 / rows, x = -1.2 + (i % rows + 0.5) * step, y = -1.2 + (i / rows + 0.5) * step;
        spread += double{map.irradiance(point_at({x, y, 0}, up), up, rule_of(k)).E.g} * step * step;
        others += double{map.irradiance(point_at({x, y, 0}, up), up, disc).E.g} * step * step;
    }
    EXPECT_NEAR(spread / flux, 1, 0.002);
    EXPECT_GT(others / flux, 1.05);
}

TEST(Spread, AtTheTopOfAPeakHasLittleBias) {
    const Found found = at_origin(250, 30'000, 0.2F, peak);
    EXPECT_NEAR(found.spread.mean(), 1, 0.01);
    EXPECT_LT(found.disc.mean(), 0.98);
    EXPECT_LT(found.spread.deviation(), 1.1 * std::sqrt(1.5 / 250));
}

TEST(Spread, InShadowBesideAnEdgeBlursLessThanDiscsOfLookups) {
    const Found found = at_origin(100, 20'000, 0.14F, [](double x, double) { return x > 0.02 ? 1.0 : 0.05; });
    EXPECT_LT(found.spread.mean() - 0.05, 0.7 * (found.disc.mean() - 0.05));
}

TEST(Spread, OnALineOfLightBlursLessThanDiscsOfLookups) {
    const Found found =
        at_origin(100, 250'000, 0.05F, [](double x, double y) { return std::exp(-(x * x + 0 * y) / 2e-4); });
    EXPECT_NEAR(found.spread.mean(), 1, 0.75 * (1 - found.disc.mean()));
}

TEST(Spread, DiscsAreNoLargerThanAllowed) {
    PhotonMap map = map_of(1, 1000, 0.5F, [](double, double) { return 1.0; });
    LookupRule rule = rule_of(500);
    rule.max_radius = 0.05F;
    map.spread(rule);
    EXPECT_LE(map.irradiance(point_at({}, up), up, rule).radius, rule.max_radius);
    EXPECT_EQ(map.irradiance(point_at({0.6, 0, 0}, up), up, rule).E.g, 0);
    EXPECT_GT(map.irradiance(point_at({0.52, 0, 0}, up), up, rule).E.g, 0);
}

TEST(Spread, WhereDiscsComeToBeTheWidestIsNotDark) {
    // Of light that falls to a 20th per unit: at x = 0 a disc of 0.25 holds k photons.
    constexpr std::uint32_t k = 200;
    const auto f = [](double x, double) { return std::exp(-3 * (x + 0.9)); };
    LookupRule rule = rule_of(k);
    rule.max_radius = 0.25F;
    const double density = k / (std::numbers::pi * 0.25 * 0.25 * f(0, 0));
    Moments m;
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        PhotonMap map = map_of(seed, density, 0.9F, f);
        map.spread(rule);
        double sum = 0;
        for (int i = -6; i <= 6; ++i)
            sum += double{map.irradiance(point_at({0.05, i * 0.1, 0}, up), up, rule).E.g} / (13 * f(0.05, 0));
        m.add(sum);
    }
    EXPECT_NEAR(m.mean(), 1, 0.015) << m.standard_error();
    EXPECT_LT(m.standard_error(), 0.01);
}

TEST(Spread, OfPhotonsAtOnePlaceIsFinite) {
    for (const std::size_t count : {1U, 2U, 100U}) {
        std::vector<Photon> photons(count, {{1, 2, 3}, encode_flux(Rgb(1), 1), 0, encode_direction(up), 0, {}, {}, 0});
        PhotonMap map(photons, {}, 1);
        map.spread(rule_of(50));
        const SurfacePoint there = point_at({1, 2, 3}, up), elsewhere = point_at({2, 2, 3}, up);
        EXPECT_TRUE(is_finite(map.irradiance(there, up, rule_of(50)).E)) << count;
        EXPECT_EQ(map.irradiance(elsewhere, up, rule_of(50)).E.g, 0);
    }
    PhotonMap none;
    none.spread(rule_of(50));
    EXPECT_EQ(none.irradiance(point_at({}, up), up, rule_of(50)).k, 0U);
}

TEST(KdTree, VisitsThePointsThatReachAsBruteForceDoes) {
    Random random;
    for (const Cloud cloud : all_clouds)
        for (std::uint32_t seed = 0; seed < 20; ++seed) {
            const PointTree<Photon> tree(cloud_of(cloud, 1 + random.below(2000), seed));
            const auto nodes = tree.nodes();
            KdReach reach(nodes.size());
            std::vector<float> of_point(tree.size());
            // A right child comes after its parent and its left sibling: from the last on, both sides are known.
            for (std::size_t i = nodes.size(); i-- > 0;) {
                if (!nodes[i].is_bucket()) {
                    reach.set(i, std::max(reach[i + 1], reach[i + nodes[i].right()]));
                    continue;
                }
                reach.set(i, 0.3F * random.next());
                const Bucket bucket = nodes[i].bucket();
                std::fill_n(of_point.begin() + bucket.first, bucket.count, reach[i]);
            }
            const PointQuery query{.p = place(random, cloud)};
            std::vector<std::uint32_t> found, expected;
            tree.visit_reaching(query, reach, [&](std::uint32_t i, float, float r2) {
                found.push_back(i);
                EXPECT_EQ(r2, of_point[i] * of_point[i]);
            });
            for (std::uint32_t i = 0; i < tree.size(); ++i) {
                const Vec3 d = tree.position(i) - query.p;
                if (d.x * d.x + d.y * d.y + d.z * d.z < of_point[i] * of_point[i]) expected.push_back(i);
            }
            std::sort(found.begin(), found.end());
            ASSERT_EQ(found, expected);
        }
}

}  // namespace
}  // namespace cardioid::photon::test

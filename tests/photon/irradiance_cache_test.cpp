#include "photon/cache/irradiance_cache.hpp"

#include <gtest/gtest.h>
#include <random>

namespace cardioid::photon {
namespace {

const Box3d box{{-1, -1, -1}, {1, 1, 1}};

CacheRecord record(Vec3 p, Vec3 n, float E, float reach) {
    CacheRecord r;
    r.p = p, r.n = n, r.E = Rgb(E);
    r.distance = 10;
    r.least = r.most = reach;
    return r;
}

IrradianceCache random_floor(std::size_t count, const std::function<CacheRecord(Vec3)>& make) {
    IrradianceCache cache({}, box);
    std::mt19937 bits(3);
    std::uniform_real_distribution<float> u(-1, 1);
    std::vector<CacheRecord> records;
    for (std::size_t i = 0; i < count; ++i) {
        const float x = u(bits);
        records.push_back(make({x, u(bits), 0}));
    }
    cache.add(std::move(records));
    return cache;
}

const Vec3 up{0, 0, 1};

TEST(IrradianceCache, OfEvenIrradianceIsEvenBetweenItsPoints) {
    const IrradianceCache cache = random_floor(500, [](Vec3 p) { return record(p, up, 2.5F, 0.2F); });
    for (double x = -0.9; x < 0.9; x += 0.013) {
        const auto E = cache.irradiance({x, 0.7 * x, 0}, up);
        ASSERT_TRUE(E);
        EXPECT_NEAR(E->g, 2.5F, 2.5e-6F);
    }
}

TEST(IrradianceCache, ReproducesWhatChangesEvenly) {
    const auto truth = [](double x, double y) { return 3 + x + 0.5 * y; };
    const IrradianceCache cache = random_floor(500, [&](Vec3 p) {
        CacheRecord r = record(p, up, static_cast<float>(truth(double{p.x}, double{p.y})), 0.2F);
        r.translational = {{1, 0.5F, 0}, {1, 0.5F, 0}, {1, 0.5F, 0}};
        return r;
    });
    for (double x = -0.9; x < 0.9; x += 0.013)
        EXPECT_NEAR(cache.irradiance({x, 0.4 - x / 2, 0}, up)->g, truth(x, 0.4 - x / 2), 1e-5);
}

TEST(IrradianceCache, AveragesTheNoiseOfItsPoints) {
    std::mt19937 bits(5);
    std::uniform_real_distribution<float> noise(-0.1F, 0.1F);
    const IrradianceCache cache = random_floor(500, [&](Vec3 p) { return record(p, up, 1 + noise(bits), 0.2F); });
    double before = 0, after = 0;
    for (const CacheRecord& r : cache.records()) {
        const float E = cache.irradiance(Vec3d(r.p), up)->g;
        before += double{(r.E.g - 1) * (r.E.g - 1)};
        after += double{(E - 1) * (E - 1)};
    }
    // Some ten points count alike, at a point's own place too.
    EXPECT_LT(std::sqrt(after), 0.5 * std::sqrt(before));
}

TEST(IrradianceCache, DoesNotGoOnWithASlopeBeyondWhatAPointKnows) {
    IrradianceCache cache({}, box);
    // Beside the edge of a lamp: all changes within 0.01, and pixels are ten times as wide.
    CacheRecord r = record({}, up, 1, 0.1F);
    r.distance = 0.01F;
    r.translational = {{100, 0, 0}, {100, 0, 0}, {100, 0, 0}};
    cache.add({r});
    EXPECT_NEAR(cache.irradiance({0.09, 0, 0}, up)->g, 1, 0.15);
    EXPECT_NEAR(cache.irradiance({-0.09, 0, 0}, up)->g, 1, 0.15);
}

TEST(IrradianceCache, TurnsWithTheNormal) {
    IrradianceCache cache({}, box);
    CacheRecord r = record({}, up, 1, 0.5F);
    // Light from +x: E grows by 1 a radian as the normal turns about +y.
    r.rotational = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
    cache.add({r});
    const float angle = 0.1F;
    EXPECT_NEAR(cache.irradiance({}, {std::sin(angle), 0, std::cos(angle)})->r, 1 + angle, 1e-3);
    EXPECT_NEAR(cache.irradiance({}, {-std::sin(angle), 0, std::cos(angle)})->r, 1 - angle, 1e-3);
}

TEST(IrradianceCache, HasNothingForOtherSidesAndPlacesBehind) {
    IrradianceCache cache({}, box);
    cache.add({record({}, up, 1, 0.5F)});
    EXPECT_TRUE(cache.irradiance({0.3, 0, 0}, up));
    EXPECT_FALSE(cache.irradiance({0.6, 0, 0}, up));
    EXPECT_FALSE(cache.irradiance({0, 0, 0}, -up));
    EXPECT_FALSE(cache.irradiance({0, 0, 0}, {1, 0, 0}));
    EXPECT_FALSE(cache.irradiance({0.1, 0, -0.1}, up));
    EXPECT_TRUE(cache.irradiance({0.1, 0, -0.01}, up));
    EXPECT_FALSE(cache.irradiance({5, 5, 5}, up));
    EXPECT_FALSE(IrradianceCache({}, box).irradiance({}, up));
}

TEST(IrradianceCache, PointsFadeInWithoutASeam) {
    IrradianceCache cache({}, box);
    cache.add({record({0, 0, 0}, up, 1, 0.5F), record({0.45F, 0, 0}, up, 2, 0.25F)});
    float before = cache.irradiance({0, 0, 0}, up)->g;
    for (double x = 0.0005; x < 0.45; x += 0.0005) {
        const float E = cache.irradiance({x, 0, 0}, up)->g;
        EXPECT_LT(std::abs(E - before), 0.005F * before) << x;
        before = E;
    }
}

TEST(IrradianceCache, LacksAPointBeforeItHasNone) {
    IrradianceCache cache({}, box);
    EXPECT_TRUE(cache.lacks({}, up));
    cache.add({record({}, up, 1, 0.5F)});
    EXPECT_FALSE(cache.lacks({0.3, 0, 0}, up));
    EXPECT_TRUE(cache.lacks({0.45, 0, 0}, up));
    EXPECT_TRUE(cache.irradiance({0.45, 0, 0}, up));
}

TEST(IrradianceCache, NeighboursLimitEachOther) {
    IrradianceCache cache({.reach = 0.5F}, box);
    CacheRecord wide = record({}, up, 1, 0), narrow = record({0.1F, 0, 0}, up, 1, 0);
    wide.distance = 10, narrow.distance = 0.2F;
    wide.most = narrow.most = 10;
    cache.add({wide, narrow});
    EXPECT_NEAR(cache.reach(cache.records()[0]), 0.5F * 0.3F, 1e-6);
    EXPECT_NEAR(cache.reach(cache.records()[1]), 0.5F * 0.2F, 1e-6);
    // The other way round it is the later that is limited.
    IrradianceCache turned({.reach = 0.5F}, box);
    turned.add({narrow, wide});
    EXPECT_NEAR(turned.reach(turned.records()[1]), 0.5F * 0.3F, 1e-6);
}

/// What a hemisphere at the origin sees of a wall in the plane x = 0.2 of any height.
Occluders wall_at(float x) {
    const Hemisphere h = Hemisphere::of(256);
    std::vector<HemisphereRay> rays;
    for (int j = 0; j < h.rings; ++j)
        for (int k = 0; k < h.sectors; ++k) {
            Sampler sampler(0, Purpose::test, static_cast<std::uint64_t>(j), static_cast<std::uint32_t>(k));
            const Vec3 d = h.direction(j, k, sampler.next2());
            const float t = d.x > 0 ? x / d.x : std::numeric_limits<float>::infinity();
            rays.push_back({{}, t, d});
        }
    return {h, rays, 1};
}

TEST(Occluders, EndAtAWallAndNowhereElse) {
    const Occluders occluders = wall_at(0.2F);
    EXPECT_NEAR(occluders.nearest(), 0.2F, 0.02F);
    for (float angle = -3.1F; angle < 3.1F; angle += 0.05F)
        for (const float d : {0.05F, 0.15F, 0.3F, 0.6F}) {
            const Vec3 v{d * std::cos(angle), d * std::sin(angle), 0};
            if (std::abs(v.x - 0.2F) < 1e-3F || std::abs(angle) > 1.2F) continue;
            EXPECT_EQ(occluders.free(v), v.x < 0.2F) << v.x << ' ' << v.y;
        }
    EXPECT_TRUE(occluders.free({-0.7F, 0.1F, 0}));
    EXPECT_TRUE(Occluders().free({100, 100, 0}));
    EXPECT_TRUE(wall_at(2).free({1.5F, 0, 0}));
}

}  // namespace
}  // namespace cardioid::photon

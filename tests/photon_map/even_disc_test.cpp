#include "photon/map/even_disc.hpp"

#include <gtest/gtest.h>
#include <numbers>

#include "tests/photon_map/planes.hpp"

namespace cardioid::photon::test {
namespace {

constexpr Vec3 up{0, 0, 1};
using Light = double (*)(double, double);

/// Relative errors of lookups at the origin under light `f` (times `density` photons a unit of area), by 50 and 700
/// photons and by a disc that adapts up to 700.
struct Errors {
    double fifty, most, adapted;
};
Errors errors(double density, float half, Light f) {
    constexpr int n = 250;
    const LookupRule rule{.k = 700, .adapt = true, .kernel = Kernel::box, .edge = EdgeRule::none};
    LookupRule fifty = rule, most = rule;
    fifty.k = 50;
    fifty.adapt = most.adapt = false;
    const double truth = f(0, 0);
    double squares[3] = {};
    for (int i = 0; i < n; ++i) {
        PhotonScene scene(static_cast<std::uint32_t>(i));
        const auto at = [half](double u) { return (2 * u - 1) * double{half}; };
        scene.add({-half, -half, 0}, {2 * half, 0, 0}, {0, 2 * half, 0}, up, density,
                  [&](double u, double v) { return f(at(u), at(v)); });
        const PhotonMap map = scene.map(density);
        int j = 0;
        for (const LookupRule& r : {fifty, most, rule})
            squares[j++] += std::pow(double{map.irradiance(point_at({}, up), up, r).E.g} / truth - 1, 2);
    }
    const auto root = [](double sum) { return std::sqrt(sum / n); };
    return {root(squares[0]), root(squares[1]), root(squares[2])};
}

// The cases of the design's table of bias compensation (Schregle 2003, with 50 to 700 photons): flat 0.107, step 0.350,
// ridge 0.202.

TEST(EvenDisc, InEvenLightTakesNearlyAllPhotons) {
    const Errors e = errors(20'000, 0.12F, [](double, double) { return 1.0; });
    EXPECT_NEAR(e.fifty, 0.144, 0.02);
    EXPECT_LT(e.adapted, 0.1);
}

TEST(EvenDisc, BesideAnEdgeOfShadowStaysSmall) {
    const Errors e = errors(20'000, 0.14F, [](double x, double) { return x > -0.01 ? 1.0 : 0.0; });
    EXPECT_LT(e.adapted, e.fifty);
    EXPECT_LT(e.adapted, 0.33);
    EXPECT_GT(e.most, 0.4);
}

TEST(EvenDisc, OnALineOfLightStaysSmall) {
    const Errors e = errors(250'000, 0.1F, [](double x, double y) { return std::exp(-(x * x + 0 * y) / 2e-4); });
    EXPECT_LT(e.adapted, 0.23);
    EXPECT_GT(e.most, 0.6);
}

TEST(EvenDisc, OnAnEvenSlopeIsNearlyAsSureAsInEvenLight) {
    const Errors e = errors(20'000, 0.14F, [](double x, double) { return 0.5 + 2 * x; });
    EXPECT_LT(e.adapted, 0.8 * e.fifty);
}

TEST(EvenDisc, OfFewPhotonsIsAllOfThem) {
    for (std::uint32_t size = 0; size < 5; ++size) {
        std::vector<DiscPhoton> photons(size, {1, 0, 1, 1, 0});
        EXPECT_EQ(largest_even_disc(photons, 32), size);
    }
}

TEST(EvenDisc, EndsWithItsFarthestPhoton) {
    Random random;
    for (int round = 0; round < 100; ++round) {
        std::vector<DiscPhoton> photons(40 + random.below(400));
        for (std::uint32_t i = 0; i < photons.size(); ++i) {
            const float x = random.next() - 0.5F, y = random.next() - 0.5F;
            photons[i] = {x, y, x * x + y * y, 1, i};
        }
        const std::uint32_t even = largest_even_disc(photons, 32);
        ASSERT_GE(even, 32U);
        for (std::uint32_t i = 0; i < photons.size(); ++i) {
            const float rim = photons[even - 1].d2;
            EXPECT_TRUE(i < even ? photons[i].d2 <= rim : photons[i].d2 >= rim);
        }
    }
}

}  // namespace
}  // namespace cardioid::photon::test

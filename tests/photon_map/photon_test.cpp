#include "photon/map/photon.hpp"

#include <gtest/gtest.h>
#include <numbers>
#include <tuple>

#include "tests/photon_map/clouds.hpp"
#include "tests/photon_map/statistics.hpp"

namespace cardioid::photon::test {
namespace {

double degrees_between(Vec3d a, Vec3d b) { return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi; }

TEST(Photon, TakesThirtyTwoBytes) { EXPECT_EQ(sizeof(Photon), 32U); }

TEST(Photon, KeepsDirectionsToAThousandthOfADegree) {
    Random random;
    Moments error;
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Vec3 d = sample_sphere(random.next2());
        const double e = degrees_between(Vec3d(d), Vec3d(decode_direction(encode_direction(d))));
        error.add(e);
        worst = std::max(worst, e);
    }
    EXPECT_NEAR(error.mean(), 0.0013, 0.0001);
    EXPECT_LT(worst, 0.004);
}

TEST(Photon, KeepsTheAxesExactly) {
    for (const int axis : {0, 1, 2})
        for (const float sign : {-1.0F, 1.0F}) {
            Vec3 d;
            d[axis] = sign;
            EXPECT_EQ(decode_direction(encode_direction(d)), d);
        }
}

/// Fluxes with channels between 5 % and all of the largest, over many magnitudes.
Rgb random_flux(Random& random) {
    const auto channel = [&] { return 0.05F + 0.95F * random.next(); };
    const float scale = std::exp2(20 * random.next() - 10);
    return Rgb(channel(), channel(), channel()) * scale;
}

TEST(Photon, KeepsFluxWithoutBias) {
    Random random;
    Moments error, largest;
    for (int i = 0; i < 200'000; ++i) {
        const Rgb flux = random_flux(random);
        const Rgb kept = decode_flux(encode_flux(flux, 1), 1);
        largest.add(double{max_component(kept)} / double{max_component(flux)} - 1);
        for (const auto& [now, then] :
             {std::pair(kept.r, flux.r), std::pair(kept.g, flux.g), std::pair(kept.b, flux.b)})
            error.add(double{now} / double{then} - 1);
    }
    EXPECT_NEAR(error.mean(), 0, 5e-4);  // cutting bits off instead of rounding loses 0.4 % and more
    EXPECT_LT(error.deviation(), 0.016);
    EXPECT_NEAR(largest.mean(), 0, 1e-4);
    EXPECT_LT(largest.deviation(), 0.002);
}

TEST(Photon, KeepsPowersOfTwoAndBlackExactly) {
    for (int e = -9; e <= 15; ++e) {
        const Rgb flux(std::ldexp(1.0F, e));
        EXPECT_EQ(decode_flux(encode_flux(flux, 1), 1), flux) << e;
    }
    EXPECT_EQ(decode_flux(encode_flux(Rgb(), 3), 3), Rgb());
}

TEST(Photon, ManyOfTheSameFluxKeepItsMeanByTheirDither) {
    Random random;
    const Rgb lamp = Rgb(17, 12, 4) / 17.0F;
    for (const Rgb flux : {lamp, Rgb(511.9F, 511.4F, 0.3F), Rgb(1), Rgb(3, 0, 1e-3F)}) {
        Moments r, g, b;
        for (int i = 0; i < 100'000; ++i) {
            const Rgb kept = decode_flux(encode_flux(flux, 1, flux_dither(random.next3())), 1);
            r.add(double{kept.r}), g.add(double{kept.g}), b.add(double{kept.b});
        }
        const Rgb rounded = decode_flux(encode_flux(flux, 1), 1);
        for (const auto& [mean, exact, one] :
             {std::tuple(r, flux.r, rounded.r), std::tuple(g, flux.g, rounded.g), std::tuple(b, flux.b, rounded.b)}) {
            if (one == exact)
                EXPECT_EQ(mean.mean(), double{exact});
            else
                EXPECT_GT(mean.p_value(double{exact}), 1e-4) << exact << " became " << mean.mean();
        }
    }
    EXPECT_GT(std::abs(decode_flux(encode_flux(lamp, 1), 1).b / lamp.b - 1), 0.002F);  // what it is for
}

TEST(Photon, KeepsFluxesOfAnyUnitByItsScale) {
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const Rgb flux = random_flux(random);
        EXPECT_EQ(encode_flux(flux * 0x1p-60F, 0x1p-60F), encode_flux(flux, 1));
        EXPECT_EQ(decode_flux(encode_flux(flux, 1), 0x1p-60F), decode_flux(encode_flux(flux, 1), 1) * 0x1p-60F);
    }
}

}  // namespace
}  // namespace cardioid::photon::test

#include "photon/hemisphere/hemisphere.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <vector>

namespace cardioid::photon {
namespace {

using Light = std::function<HemisphereRay(Vec3)>;

HemisphereReading read(const Hemisphere& h, const Light& light, std::uint32_t seed, const Frame& frame = {}) {
    std::vector<HemisphereRay> rays;
    for (int j = 0; j < h.rings; ++j)
        for (int k = 0; k < h.sectors; ++k) {
            const auto cell = static_cast<std::uint32_t>(j * h.sectors + k);
            Sampler sampler(seed, Purpose::test, 0, cell);
            rays.push_back(light(frame.to_world(h.direction(j, k, sampler.next2()))));
        }
    return read_hemisphere(h, frame, rays);
}

double mean_irradiance(const Hemisphere& h, const std::function<float(Vec3)>& radiance, std::uint32_t seeds = 100) {
    double sum = 0;
    for (std::uint32_t seed = 0; seed < seeds; ++seed)
        sum += static_cast<double>(read(
                                       h,
                                       [&](Vec3 d) {
                                           return HemisphereRay{Rgb(radiance(d)), 1};
                                       },
                                       seed)
                                       .E.g);
    return sum / seeds;
}

// Radiances with known irradiance: accuracy.md, A2.
float even(Vec3) { return 1; }
float cosine(Vec3 d) { return d.z; }
float horizon(Vec3 d) { return d.z < 0.5F ? 1.0F : 0.0F; }
float zenith(Vec3 d) { return d.z > std::cos(pi / 6) ? 1.0F : 0.0F; }
float narrow(Vec3 d) { return std::pow(d.z, 8.0F); }
float half_wall(Vec3 d) { return d.y > 0 ? 1.0F : 0.0F; }

TEST(Hemisphere, HasAtLeastAsManyRaysAsAskedFor) {
    for (const int rays : {2, 64, 256, 600, 4000}) {
        const Hemisphere h = Hemisphere::of(rays);
        EXPECT_GE(h.size(), rays);
        EXPECT_LE(h.size(), rays + h.rings + 4);
    }
    EXPECT_NEAR(Hemisphere::of(616).sectors, 44, 1);
}

TEST(Hemisphere, OfEvenLightIsPiWhateverItsSize) {
    for (const int rays : {4, 78, 256, 1000})
        EXPECT_NEAR(mean_irradiance(Hemisphere::of(rays), even, 1), std::numbers::pi, 1e-6);
}

TEST(Hemisphere, AgreesWithClosedFormsInTheMean) {
    const Hemisphere h = Hemisphere::of(256);
    const double pi_d = std::numbers::pi;
    EXPECT_NEAR(mean_irradiance(h, cosine) / (2 * pi_d / 3), 1, 0.005);
    EXPECT_NEAR(mean_irradiance(h, horizon) / (pi_d / 4), 1, 0.005);
    EXPECT_NEAR(mean_irradiance(h, zenith) / (pi_d / 4), 1, 0.005);
    EXPECT_NEAR(mean_irradiance(h, narrow) / (pi_d / 5), 1, 0.005);
}

// report-checklist.md, table 1.3: the report's 6 rings and 13 sectors, its cells and its quarter of a cell.
TEST(Hemisphere, OfTheReportIsAsWrongAsMeasured) {
    const double pi_d = std::numbers::pi;
    const auto ratios = [&](HemisphereCells cells, float jitter) {
        const Hemisphere h{6, 13, cells, jitter};
        return std::vector<double>{mean_irradiance(h, cosine) / (2 * pi_d / 3),
                                   mean_irradiance(h, horizon) / (pi_d / 4), mean_irradiance(h, zenith) / (pi_d / 4),
                                   mean_irradiance(h, narrow) / (pi_d / 5)};
    };
    const auto expect = [](const std::vector<double>& got, const std::vector<double>& wanted) {
        for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(got[i], wanted[i], 0.004) << i;
    };
    expect(ratios(HemisphereCells::equal_angle, 1), {0.955, 1.333, 1.333, 1.367});
    expect(ratios(HemisphereCells::equal_solid_angle, 1), {0.750, 2.000, 0.534, 0.555});
    expect(ratios(HemisphereCells::cosine, 1), {1.000, 0.999, 0.998, 1.000});
    expect(ratios(HemisphereCells::cosine, 0.5F), {0.943, 1.333, 0.667, 0.793});
    EXPECT_NEAR(mean_irradiance({6, 13, HemisphereCells::cosine, 0.5F}, half_wall) / (pi_d / 2), 0.923, 1e-3);
}

/// What is seen from p inside the unit cube: its ceiling shines with 1, its walls x0 3, x1 0.2, y0 0.5, y1 1.5.
HemisphereRay look_in_cube(Vec3 p, Vec3 d) {
    const float x = (d.x > 0 ? 1 - p.x : -p.x) / d.x, y = (d.y > 0 ? 1 - p.y : -p.y) / d.y, z = (1 - p.z) / d.z;
    if (z <= std::min(x, y)) return {Rgb(1), z};
    if (x < y) return {Rgb(d.x < 0 ? 3.0F : 0.2F), x};
    return {Rgb(d.y < 0 ? 0.5F : 1.5F), y};
}

struct Slopes {
    Vec3d rotational, translational;
};

Slopes mean_slopes(const Hemisphere& h, Vec3 p) {
    Slopes mean;
    constexpr std::uint32_t seeds = 100;
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const HemisphereReading one = read(
            h, [&](Vec3 d) { return look_in_cube(p, d); }, seed);
        mean.rotational += Vec3d(one.rotational.g) / seeds;
        mean.translational += Vec3d(one.translational.g) / seeds;
    }
    return mean;
}

void expect_near(Vec3d got, double x, double y, double share) {
    const double tolerance = share * std::hypot(x, y);
    EXPECT_NEAR(got.x, x, tolerance);
    EXPECT_NEAR(got.y, y, tolerance);
    EXPECT_NEAR(got.z, 0, 1e-6);
}

// Exact gradients of form factors by finite differences.
TEST(Hemisphere, GradientsAgreeWithTheExactOnesOfACube) {
    for (const Hemisphere& h : {Hemisphere{14, 44}, Hemisphere{60, 188}}) {
        const double translational = h.rings == 14 ? 0.05 : 0.02;
        const Slopes middle = mean_slopes(h, {0.5F, 0.5F, 0});
        expect_near(middle.translational, -3.4559, 1.2342, translational);
        expect_near(middle.rotational, -1.0476, -2.9447, 0.02);
        const Slopes beside = mean_slopes(h, {0.3F, 0.6F, 0});
        expect_near(beside.translational, -4.1844, 0.7575, translational);
        expect_near(beside.rotational, -0.8259, -3.2351, 0.02);
    }
}

TEST(Hemisphere, GradientsTurnWithTheFrame) {
    const Frame frame(normalize(Vec3{1, 2, -2}));
    const Hemisphere h = Hemisphere::of(600);
    const HemisphereReading flat = read(
        h,
        [](Vec3 d) {
            return look_in_cube({0.3F, 0.6F, 0}, d);
        },
        3);
    const HemisphereReading tilted = read(
        h,
        [&](Vec3 d) {
            return look_in_cube({0.3F, 0.6F, 0}, frame.to_local(d));
        },
        3, frame);
    EXPECT_LT(length(frame.to_local(tilted.translational.g) - flat.translational.g), 0.02F);
    EXPECT_LT(length(frame.to_local(tilted.rotational.g) - flat.rotational.g), 0.02F);
}

TEST(Hemisphere, HarmonicDistanceCountsWhatIsFarAwayLittle) {
    const Hemisphere h = Hemisphere::of(400);
    EXPECT_FLOAT_EQ(read(
                        h,
                        [](Vec3) {
                            return HemisphereRay{Rgb(1), 4};
                        },
                        0)
                        .harmonic_distance,
                    4);
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(read(
                  h,
                  [&](Vec3) {
                      return HemisphereRay{Rgb(1), infinity};
                  },
                  0)
                  .harmonic_distance,
              infinity);
    const auto half = [&](Vec3 d) { return HemisphereRay{Rgb(1), d.x > 0 ? 2 : infinity}; };
    EXPECT_NEAR(read(h, half, 0).harmonic_distance, 4, 0.2);
    EXPECT_TRUE(is_finite(read(h, half, 0).translational.g));
}

TEST(Hemisphere, TellsItsOwnErrorWithinAFactor) {
    const Hemisphere h = Hemisphere::of(256);
    for (const auto& radiance : {cosine, horizon, narrow, half_wall}) {
        double sum = 0, squares = 0, told = 0;
        constexpr std::uint32_t seeds = 200;
        for (std::uint32_t seed = 0; seed < seeds; ++seed) {
            const auto one = read(
                h,
                [&](Vec3 d) {
                    return HemisphereRay{Rgb(radiance(d)), 1};
                },
                seed);
            sum += static_cast<double>(one.E.g), squares += static_cast<double>(one.E.g * one.E.g);
            told += static_cast<double>(one.error) / seeds;
        }
        const double deviation = std::sqrt(std::max(0.0, squares / seeds - sum / seeds * (sum / seeds)));
        EXPECT_GT(told, deviation);
        EXPECT_LT(told, 0.1);
    }
}

}  // namespace
}  // namespace cardioid::photon

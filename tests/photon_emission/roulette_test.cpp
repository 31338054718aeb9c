#include "photon/propagation/roulette.hpp"

#include <gtest/gtest.h>

#include "emission_kit.hpp"

#include "tests/shaders/statistics.hpp"

namespace cardioid {
namespace {

using photon::pass_medium;
using photon::Roulette;
using photon::scatter;
using photon::Scattered;
using test::Random;
using test::SceneKit;

/// Diffuse, mirror and straight through, with albedos of its own.
class ThreeWays final : public Bsdf {
public:
    explicit ThreeWays(Albedo albedo) : albedo_(albedo) {}
    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse | Lobe::specular | Lobe::transmitted; }
    [[nodiscard]] Rgb f(Vec3, Vec3) const noexcept override { return albedo_.diffuse * inv_pi; }
    [[nodiscard]] float pdf(Vec3, Vec3 wi, Lobe) const noexcept override { return wi.z * inv_pi; }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float u_lobe, Vec2 u, Lobe which) const noexcept override {
        if (which == (Lobe::diffuse | Lobe::transmitted))
            return {sample_cosine_hemisphere(u), albedo_.diffuse, 1, Lobe::diffuse};
        const float r = max_component(albedo_.specular), t = max_component(albedo_.transmitted), share = r / (r + t);
        if (u_lobe < share) return {{-wo.x, -wo.y, wo.z}, albedo_.specular / share, 0, Lobe::specular};
        return {-wo, albedo_.transmitted / (1 - share), 0, Lobe::specular | Lobe::transmitted};
    }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return albedo_; }

private:
    Albedo albedo_;
};

/// A box of one material, seen from above at an angle.
struct Place {
    explicit Place(const std::string& kind,
                   std::initializer_list<std::pair<const char*, std::vector<double>>> values = {})
        : kit([&] {
              SceneKit made;
              made.root(made.box({-1, -1, -1}, {1, 1, 0}, made.material("m", kind, values)));
              return made;
          }()),
          world(kit.commit()),
          point(test::seen(world, {0.1, 0.2, 1}, {0, 0, -1})) {}
    [[nodiscard]] const Bsdf& bsdf() { return *world.bsdf(point, memory); }

    SceneKit kit;
    CommittedScene world;
    SurfacePoint point;
    BsdfMemory memory;
};

Vec3 at_angle(double degrees, double side = 1) {
    const double a = degrees * std::numbers::pi / 180;
    return {static_cast<float>(std::sin(a)), 0, static_cast<float>(side * std::cos(a))};
}

/// Draws n times and says how often each way was taken: diffuse, specular, transmitted, absorbed.
std::array<double, 4> ways(const photon::ScatterQuery& query, int n) {
    Random random(7);
    std::array<double, 4> counts{};
    for (int i = 0; i < n; ++i) {
        const Vec2 u = random.next2();
        const Scattered s = scatter(query, u, random.next2());
        const std::size_t way = is_black(s.flux)                  ? 3
                                : any(s.lobe & Lobe::transmitted) ? 2
                                : any(s.lobe & Lobe::diffuse)     ? 0
                                                                  : 1;
        ++counts[way];
    }
    return counts;
}

double p_of_counts(const std::array<double, 4>& counts, const std::array<double, 4>& shares, double n) {
    double chi = 0;
    int cells = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        if (shares[i] <= 1e-9) {
            if (counts[i] > 0) return 0;
            continue;
        }
        chi += (counts[i] - shares[i] * n) * (counts[i] - shares[i] * n) / (shares[i] * n);
        ++cells;
    }
    return test::chi_squared_p(chi, std::max(1, cells - 1));
}

// ARL-TR-3608, equations 2 to 4, with transmission and the rule of the largest channel.
TEST(Roulette, DrawsEachWayAsOftenAsItsShareOfTheLargestChannel) {
    Place place("diffuse");
    constexpr int n = 1'000'000;
    const Rgb flux(0.5F, 1, 2);
    for (const Albedo& a : {Albedo{{0.5F, 0.3F, 0.2F}, Rgb(0.1F), Rgb(0.2F)}, Albedo{Rgb(0.4F), Rgb(0.35F), Rgb(0.25F)},
                            Albedo{{0.1F, 0.9F, 0}, Rgb(0.05F), Rgb(0.05F)}}) {
        const ThreeWays bsdf(a);
        const auto share = [&](Rgb rho) { return double{max_component(rho * flux)} / double{max_component(flux)}; };
        std::array<double, 4> shares{share(a.diffuse), share(a.specular), share(a.transmitted), 0};
        shares[3] = 1 - shares[0] - shares[1] - shares[2];
        const auto counts = ways({place.world, place.point, bsdf, {0, 0, 1}, flux}, n);
        EXPECT_GT(p_of_counts(counts, shares, n), 1e-4);
        shares[0] *= 1.02;
        shares[1] -= 0.02 * shares[0] / 1.02;
        EXPECT_LT(p_of_counts(counts, shares, n), 1e-4);
    }
}

TEST(Roulette, OfTheReportDrawsByTheMeanReflectance) {
    Place place("diffuse", {{"reflectance", {0.8, 0.4, 0.1}}});
    constexpr int n = 200'000;
    const double mean = 1.3 / 3;
    photon::ScatterQuery query{place.world, place.point, place.bsdf(), {0, 0, 1}, Rgb(1)};
    query.rule.by = Roulette::mean;
    EXPECT_GT(p_of_counts(ways(query, n), {mean, 0, 0, 1 - mean}, n), 1e-4);
    Random random;
    Rgb sum;
    query.rule.double_count = true;
    for (int i = 0; i < n; ++i) {
        const Vec2 u = random.next2();
        sum += scatter(query, u, random.next2()).flux / n;
    }
    // Reflectance counted twice: the roulette's chance and the colour.
    EXPECT_NEAR(sum.r, 0.8 * mean, 0.8 * mean * 0.01);
}

/// Mean flux that scatter() leaves of 1 W, per channel, against `wanted`: the p-values of it and of 2 % more.
void expect_mean(const photon::ScatterQuery& query, Rgb wanted, int n = 150'000) {
    Random random(3);
    double sum[3] = {}, square[3] = {};
    for (int i = 0; i < n; ++i) {
        const Vec2 u = random.next2();
        const Rgb f = scatter(query, u, random.next2()).flux;
        const double c[3] = {f.r, f.g, f.b};
        for (int k = 0; k < 3; ++k) sum[k] += c[k], square[k] += c[k] * c[k];
    }
    const double want[3] = {wanted.r, wanted.g, wanted.b};
    for (int k = 0; k < 3; ++k) {
        const double mean = sum[k] / n, variance = std::max(square[k] / n - mean * mean, 0.0);
        const double sigma = std::sqrt(variance / n) + 2e-4 * want[k];  // tables of albedos are that good
        EXPECT_GT(test::p_of_z((mean - want[k]) / sigma), 1e-4) << k << ": " << mean << " for " << want[k];
        if (want[k] > 0.3) {
            EXPECT_LT(test::p_of_z((mean - want[k] * 1.02) / sigma), 1e-4) << k;
        }
    }
}

TEST(Roulette, LeavesTheAlbedoOnAverage) {
    Place places[] = {Place("diffuse", {{"reflectance", {0.8, 0.4, 0.1}}}),
                      Place("phong", {{"diffuse", {0.5, 0.3, 0.3}}, {"specular", {0.4, 0.3, 0.1}}}),
                      Place("plastic", {{"reflectance", {0.9, 0.5, 0.2}}}),
                      Place("plastic", {{"reflectance", {0.9, 0.5, 0.2}}, {"roughness", {0.5}}}),
                      Place("conductor", {{"roughness", {0.6}}}),
                      Place("mirror", {{"reflectance", {0.9, 0.6, 0.3}}}),
                      Place("filter", {{"reflectance", {0.5, 0.2, 0.1}}, {"transmittance", {0.3, 0.6, 0.9}}})};
    for (Place& place : places)
        for (const double degrees : {10.0, 60.0}) {
            SCOPED_TRACE(place.kit.scene.materials.back().kind);
            const Vec3 wo = at_angle(degrees);
            expect_mean({place.world, place.point, place.bsdf(), wo, Rgb(1)}, place.bsdf().albedo(wo).total());
        }
}

// Radiance is scaled by the square of the index, flux is not.
TEST(Roulette, KeepsFluxThroughGlass) {
    Place smooth("dielectric", {{"ior", {1.5}}}), rough("dielectric", {{"ior", {1.5}}, {"roughness", {0.5}}});
    for (const double side : {1.0, -1.0})
        for (const double degrees : {5.0, 35.0, 60.0}) {
            const Vec3 wo = at_angle(degrees, side);
            expect_mean({smooth.world, smooth.point, smooth.bsdf(), wo, Rgb(1)}, Rgb(1), 1000);
            expect_mean({rough.world, rough.point, rough.bsdf(), wo, Rgb(1)}, rough.bsdf().albedo(wo).total());
        }
}

TEST(Roulette, NeverLosesTotallyReflectedPhotons) {
    Place glass("dielectric", {{"ior", {1.5}}});
    const auto counts = ways({glass.world, glass.point, glass.bsdf(), at_angle(42.5, -1), Rgb(1)}, 10'000);
    EXPECT_EQ(counts[1], 10'000);
}

TEST(Roulette, ReflectsAsFresnelSaysAndBendsAsSnellSays) {
    Place glass("dielectric", {{"ior", {1.5}}});
    constexpr int n = 200'000;
    const double in = 60 * std::numbers::pi / 180, out = std::asin(std::sin(in) / 1.5);
    const double s = std::sin(in - out) / std::sin(in + out), p = std::tan(in - out) / std::tan(in + out);
    const double reflectance = (s * s + p * p) / 2;  // 0.0892
    const photon::ScatterQuery query{glass.world, glass.point, glass.bsdf(), at_angle(60), Rgb(1)};
    const auto counts = ways(query, n);
    EXPECT_GT(p_of_counts(counts, {0, reflectance, 1 - reflectance, 0}, n), 1e-4);
    EXPECT_LT(p_of_counts(counts, {0, reflectance * 1.05, 1 - reflectance * 1.05, 0}, n), 1e-4);
    const Scattered bent = scatter(query, {0.9F, 0}, {0.5F, 0.5F});
    EXPECT_NEAR(bent.wi.x, -std::sin(out), 1e-6);
    EXPECT_NEAR(bent.flux.g, 1, 1e-5);
}

// The largest channel of a survivor is what it was, so that photons stay alike.
TEST(Roulette, KeepsTheLargestChannelOfSurvivors) {
    Place place("plastic", {{"reflectance", {0.7, 0.3, 0.2}}});
    Random random;
    int survivors = 0;
    for (int i = 0; i < 10'000; ++i) {
        const Vec2 u = random.next2();
        const Scattered s = scatter({place.world, place.point, place.bsdf(), at_angle(30), Rgb(1)}, u, random.next2());
        if (!any(s.lobe & Lobe::specular)) continue;
        EXPECT_NEAR(max_component(s.flux), 1, 1e-5);
        ++survivors;
    }
    EXPECT_GT(survivors, 300);
}

TEST(Roulette, ThinsPhotonsInAnAbsorbingMedium) {
    const Medium tea{.ior = 1.33F, .absorption = {0.1F, 0.5F, 1}};
    Random random;
    constexpr int n = 100'000;
    Rgb sum;
    for (int i = 0; i < n; ++i) {
        const Rgb left = pass_medium(tea, 2, Rgb(1), random.next());
        EXPECT_TRUE(is_black(left) || std::abs(max_component(left) - 1) < 1e-5F);
        sum += left / n;
    }
    EXPECT_NEAR(sum.r, std::exp(-0.2), 0.006);
    EXPECT_NEAR(sum.b, std::exp(-2.0), 0.001);
}

// A tilted shading normal must not create or destroy flux on average where all of the lobe is above the surface.
TEST(Roulette, CorrectsForShadingNormals) {
    Place place("diffuse", {{"reflectance", {1, 1, 1}}});
    SurfacePoint tilted = place.point;
    tilted.frame = Frame(normalize(Vec3{0.2F, 0, 1}));
    const Vec3 wo = tilted.frame.to_local(normalize(Vec3{0.5F, 0.1F, 1}));
    const photon::ScatterQuery query{place.world, tilted, place.bsdf(), wo, Rgb(1)};
    // E = |wo.n| / |wo.ng| times the integral of the reflected cosine to ng, here over directions above both planes.
    const double cos_tilt = 1 / std::sqrt(1.04), above = (1 + cos_tilt) / 2;
    const Vec3 world_wo = normalize(Vec3{0.5F, 0.1F, 1});
    const double factor = double{wo.z} / double{world_wo.z} * above;
    Random random;
    double sum = 0;
    constexpr int n = 200'000;
    for (int i = 0; i < n; ++i) {
        const Vec2 u = random.next2();
        sum += double{scatter(query, u, random.next2()).flux.r} / n;
    }
    EXPECT_NEAR(sum, factor, 0.005);
}

}  // namespace
}  // namespace cardioid

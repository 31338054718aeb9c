#include "rt_core/render/probe.hpp"

#include <atomic>
#include <gtest/gtest.h>
#include <omp.h>

#include "scene_kit.hpp"

#include "rt_core/render/lighting/direct_lighting.hpp"
#include "rt_core/render/lighting/path_lighting.hpp"

namespace cardioid {
namespace {

using test::SceneKit;

constexpr double pi_d = std::numbers::pi;

std::vector<Reading> measured(const CommittedScene& scene, const std::vector<ProbePoint>& points,
                              const ProbeSettings& settings = {}, const LightingKind& kind = direct_lighting) {
    const std::unique_ptr<LightingModule> module = kind.make({}, 0);
    Progress silent;
    module->prepare(scene, nullptr, silent);
    return probe(scene, *module, points, settings, silent);
}

Reading measured(const CommittedScene& scene, Vec3d p, Vec3d d, const ProbeSettings& settings = {}) {
    return measured(scene, std::vector<ProbePoint>{{p, d}}, settings)[0];
}

SceneKit lit_floor() {
    SceneKit kit;
    kit.root(kit.box({-5, -5, -1}, {5, 5, 0}, 0));
    kit.light("point_light", {{"intensity", {90, 45, 9}}}, Affine::translation({0, 0, 3}));
    return kit;
}

/// The same with an area lamp that half hides behind a plate, so that there is noise.
SceneKit noisy_floor() {
    SceneKit kit = lit_floor();
    kit.light("area_light", {{"size", {2, 1}}}, Affine::translation({1, 1, 2}));
    kit.root(kit.box({-3, -3, 1.8}, {1, 3, 1.9}, 0));
    return kit;
}

/// I cos / d^2 of the lamp of lit_floor on a level plate at p.
double from_point_lamp(Vec3d p) {
    const Vec3d to = Vec3d{0, 0, 3} - p;
    return 90 * to.z / std::pow(length(to), 3);
}

TEST(Probe, MeasuresPointLampsExactlyByOneSample) {
    const CommittedScene scene = lit_floor().commit();
    for (const Vec3d p : {Vec3d{0, 0, 0}, {1, 2, 0}, {-4.9, 3, 0}, {0.3, 0.2, 1.5}}) {
        const Reading r = measured(scene, p, {0, 0, 3});
        EXPECT_NEAR(r.value.r, from_point_lamp(p), 1e-5 * from_point_lamp(p));
        EXPECT_NEAR(r.value.b, 0.1 * from_point_lamp(p), 1e-6 * from_point_lamp(p));
        EXPECT_EQ(r.standard_error, Rgb{});
        EXPECT_EQ(r.samples, 1U);
        EXPECT_FALSE(r.buried);
    }
}

TEST(Probe, OfManyPointLampsSamplesSome) {
    SceneKit kit;
    kit.root(kit.box({-50, -5, -1}, {50, 5, 0}, 0));
    double wanted = 0;
    for (int i = 0; i < 40; ++i) {
        const Vec3d p{2.0 * i - 40, 0, 3};
        kit.light("point_light", {{"intensity", {1}}}, Affine::translation(p));
        wanted += p.z / std::pow(length(p), 3);
    }
    const Reading r = measured(kit.commit(), {0, 0, 0}, {0, 0, 1});
    EXPECT_GE(r.samples, 64U);
    EXPECT_GT(r.standard_error.g, 0);
    EXPECT_NEAR(r.value.g, wanted, 4 * r.standard_error.g);
}

/// Errors over their standard errors, of many points.
struct Normalised {
    double sum = 0, squares = 0;
    int n = 0;
    void add(const Reading& r, double wanted) {
        const double z = (r.value.g - wanted) / r.standard_error.g;
        sum += z, squares += z * z, ++n;
    }
    [[nodiscard]] double z_of_mean() const { return sum / std::sqrt(n); }
    [[nodiscard]] double variance() const { return squares / n; }
};

/// The readings agree with what is wanted, their errors are as large as they say, and 2 % more would be seen.
void expect_honest(const std::vector<Reading>& readings, const std::vector<double>& wanted) {
    Normalised right, wrong;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        right.add(readings[i], wanted[i]);
        wrong.add(readings[i], wanted[i] * 1.02);
        EXPECT_TRUE(readings[i].reached);
    }
    EXPECT_LT(std::abs(right.z_of_mean()), 3.9);
    EXPECT_LT(wrong.z_of_mean(), -3.9);
    // Chi-squared of n degrees has the variance 2 n; 64 means make t-values, whose variance is 63/61.
    EXPECT_NEAR(right.variance(), 63.0 / 61, 3.9 * std::sqrt(2.0 / right.n));
}

TEST(Probe, StandardErrorsOfABallLampAreHonest) {
    // E = pi L (r/d)^2 cos where all of the ball is above the horizon.
    SceneKit kit;
    kit.root(kit.box({-50, -50, -1}, {50, 50, 0}, 0));
    kit.light("sphere_light", {{"r", {1}}, {"radiance", {3}}}, Affine::translation({0, 0, 4}));
    std::vector<ProbePoint> points;
    std::vector<double> wanted;
    for (int i = 0; i < 500; ++i) {
        const Vec3d p{0.02 * i, 0.01 * i, 0};
        const double d = length(Vec3d{0, 0, 4} - p);
        points.push_back({p, {0, 0, 1}});
        wanted.push_back(pi_d * 3 / (d * d) * 4 / d);
    }
    expect_honest(measured(kit.commit(), points, {.noise = 0.002}), wanted);
}

TEST(Probe, StandardErrorsUnderASkyBehindAWallAreHonest) {
    // A black wall, high h and very long, at distance x takes (1 - cos(atan(h/x)))/2 of what an even sky gives.
    SceneKit kit;
    const std::uint32_t black = kit.material("black", "diffuse", {{"reflectance", {0}}});
    kit.root(kit.box({-1, -2000, 0}, {0, 2000, 2}, black));
    kit.light("sky", {{"radiance", {2, 2, 2}}});
    std::vector<ProbePoint> points;
    std::vector<double> wanted;
    for (int i = 0; i < 500; ++i) {
        const double x = 0.1 + 0.01 * i;
        points.push_back({{x, 0.003 * i, 0}, {0, 0, 1}});
        wanted.push_back(2 * pi_d * (1 - (1 - x / std::hypot(x, 2.0)) / 2));
    }
    expect_honest(measured(kit.commit(), points, {.noise = 0.01}), wanted);
}

TEST(Probe, StandardErrorsOfPathsInAClosedBoxAreHonest) {
    // Inside a closed ball of radiance 1 and reflectance 0.5 every plate gets pi / (1 - 0.5).
    SceneKit kit;
    const std::uint32_t glow = kit.material("glow", "diffuse", {{"reflectance", {0.5}}, {"emission", {1}}});
    kit.root(
        kit.scene.solids.add_node(SolidOp::subtract, {kit.box({-2, -2, -2}, {2, 2, 2}, glow), kit.ball({}, 1, glow)}));
    std::vector<ProbePoint> points;
    for (int i = 0; i < 200; ++i) {
        Sampler sampler(1, Purpose::test, static_cast<std::uint64_t>(i), 0);
        const Vec3d n(sample_sphere(sampler.next2()));
        points.push_back({n * (i % 2 == 0 ? 1.0 : 0.7), -n});
    }
    const std::vector<double> wanted(points.size(), 2 * pi_d);
    expect_honest(measured(kit.commit(), points, {.noise = 0.02}, path_lighting), wanted);
}

bool same(const Reading& a, const Reading& b) {
    return a.value == b.value && a.standard_error == b.standard_error && a.samples == b.samples;
}

TEST(Probe, HasTheSameBitsForAnyThreadsAndAnyOtherPoints) {
    const CommittedScene scene = noisy_floor().commit();
    std::vector<ProbePoint> points;
    for (int i = 0; i < 1100; ++i) points.push_back({{1 + 0.002 * i, 1 - 0.002 * i, 0}, {0, 0.1, 1}});
    omp_set_num_threads(1);
    const std::vector<Reading> one = measured(scene, points);
    omp_set_num_threads(3);
    const std::vector<Reading> three = measured(scene, points);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_TRUE(same(one[i], three[i])) << i;
    const std::vector<Reading> part = measured(scene, {points.begin() + 500, points.begin() + 700}, {.first = 500});
    for (std::size_t i = 0; i < part.size(); ++i) EXPECT_TRUE(same(part[i], one[500 + i])) << i;
    // One point alone is shared out among threads too.
    const ProbeSettings fine{.noise = 1e-3};
    const Reading together = measured(scene, points[100].p, points[100].d, fine);
    omp_set_num_threads(1);
    EXPECT_TRUE(same(measured(scene, points[100].p, points[100].d, fine), together));
    EXPECT_GT(together.samples, 4096U);
    omp_set_num_threads(omp_get_num_procs());
}

TEST(Probe, TakesAsManySamplesAsItIsTold) {
    const CommittedScene scene = noisy_floor().commit();
    const auto samples = [&](const ProbeSettings& s) { return measured(scene, {1, 0, 0}, {0, 0, 1}, s).samples; };
    EXPECT_EQ(samples({.noise = 0, .most_samples = 1024}), 1024U);
    EXPECT_EQ(samples({.noise = 0, .most_samples = 16}), 16U);
    EXPECT_EQ(samples({.noise = 0, .most_samples = 40}), 40U);
    EXPECT_EQ(samples({.noise = 0, .most_samples = 130}), 128U);
    EXPECT_EQ(samples({.noise = 1e-7, .most_samples = 512}), 512U);
    EXPECT_FALSE(measured(scene, {1, 0, 0}, {0, 0, 1}, {.noise = 1e-7, .most_samples = 512}).reached);
    EXPECT_LT(samples({.noise = 0.1}), samples({.noise = 0.001}));
    EXPECT_FALSE(same(measured(scene, {1, 0, 0}, {0, 0, 1}), measured(scene, {1, 0, 0}, {0, 0, 1}, {.seed = 1})));
}

TEST(Probe, EndsInTheDark) {
    SceneKit kit = lit_floor();
    kit.scene.lights.clear();
    const Reading unlit = measured(kit.commit(), {0, 0, 0}, {0, 0, 1});
    EXPECT_EQ(unlit.value, Rgb{});
    EXPECT_EQ(unlit.samples, 1U);
    kit.light("area_light", {{"size", {1, 1}}}, Affine::translation({0, 0, 2}));
    kit.root(kit.box({-2, -2, 1}, {2, 2, 1.1}, 0));
    const Reading shaded = measured(kit.commit(), {0, 0, 0}, {0, 0, 1});
    EXPECT_EQ(shaded.value, Rgb{});
    EXPECT_EQ(shaded.samples, 1024U);
    EXPECT_TRUE(shaded.reached);
    EXPECT_FALSE(shaded.buried);
}

/// Light that is not a number at every third sample, or so.
class BadLighting final : public LightingModule {
    [[nodiscard]] Rgb indirect(const World&, const SurfacePoint&, const Bsdf&, Vec3,
                               Sampler& s) const noexcept override {
        return s.next() < 0.33F ? Rgb(std::numeric_limits<float>::quiet_NaN()) : Rgb(1);
    }
};

TEST(Probe, CountsBadSamplesAsBlack) {
    SceneKit kit = lit_floor();
    kit.scene.lights.clear();
    Progress silent;
    const ProbePoint point{{0, 0, 0}, {0, 0, 1}};
    const Reading r = probe(kit.commit(), BadLighting(), {&point, 1}, {.noise = 0, .most_samples = 4096}, silent)[0];
    EXPECT_NEAR(r.bad_samples, 0.33 * 4096, 100);
    EXPECT_NEAR(r.value.g, pi_d * (4096 - r.bad_samples) / 4096, 1e-4);
}

/// Stops after so many questions.
class Impatient final : public Progress {
public:
    explicit Impatient(int patience) : patience_(patience) {}
    [[nodiscard]] bool interrupted() const noexcept override { return --patience_ < 0; }

private:
    mutable std::atomic<int> patience_;
};

TEST(Probe, ReturnsWhatItHasWhenInterrupted) {
    const CommittedScene scene = noisy_floor().commit();
    const std::unique_ptr<LightingModule> module = direct_lighting.make({}, 0);
    const std::vector<ProbePoint> points(50, {{1, 0, 0}, {0, 0, 1}});
    Impatient at_once(0), soon(30), later(3000);
    const auto run = [&](Progress& p) { return probe(scene, *module, points, {.noise = 1e-6}, p); };
    EXPECT_EQ(run(at_once)[0].samples, 0U);
    EXPECT_EQ(run(soon)[49].samples, 0U);
    const std::vector<Reading> readings = run(later);
    for (const Reading& r : readings) {
        EXPECT_GE(r.samples, 64U);
        EXPECT_FALSE(r.reached);
        EXPECT_NEAR(r.value.g, readings[0].value.g, 5 * (r.standard_error.g + readings[0].standard_error.g));
    }
}

TEST(Probe, MeasuresRadianceAlongARay) {
    SceneKit kit = lit_floor();
    kit.light("area_light", {{"size", {2, 1}}, {"radiance", {7, 7, 7}}}, Affine::translation({3, 3, 2}));
    kit.light("sky", {{"radiance", {0.25, 0.25, 0.25}}});
    const CommittedScene scene = kit.commit();
    const ProbeSettings settings{.what = Quantity::radiance, .noise = 1e-3};
    EXPECT_NEAR(measured(scene, {3, 3, 0}, {0, 0, 1}, settings).value.g, 7, 1e-6);
    EXPECT_NEAR(measured(scene, {0, 0, 1}, {0, 1, 5}, settings).value.g, 0.25, 1e-6);
    const Reading floor = measured(scene, {0, 0, 1}, {1, 0, -1}, settings);
    const Reading plate = measured(scene, {1, 0, 0}, {0, 0, 1}, {.noise = 1e-3});
    EXPECT_NEAR(floor.value.g, 0.5 * plate.value.g / pi_d, 0.004 * floor.value.g);
}

}  // namespace
}  // namespace cardioid

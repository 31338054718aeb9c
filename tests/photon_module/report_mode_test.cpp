#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "photon/lighting/light_maps.hpp"
#include "tests/photon_map/planes.hpp"
#include "tests/photon_module/lit_scenes.hpp"

namespace cardioid::photon::test {
namespace {

using cardioid::test::Folder;
using cardioid::test::Outcome;
using nlohmann::json;

PhotonOptions report() {
    Params params;
    params.set("mode", std::string("report"));
    return read_photon_options(params);
}

/// What lookups of these options, of radius 1, say of a floor x >= 0 of irradiance 1, at x, with a wall on its edge
/// that has `wall` times the floor's photons.
Moments floor_by_a_wall(const PhotonOptions& options, double wall, double x) {
    constexpr int n = 400;
    constexpr double density = 60;
    constexpr float length = 2.2F * n + 2;
    PhotonScene scene(7);
    scene.add({}, {2.2F, 0, 0}, {0, length, 0}, {0, 0, 1}, density);
    scene.add({}, {0, length, 0}, {0, 0, 1.1F}, {1, 0, 0}, wall * density);
    const PhotonMap map = scene.map(density);
    LightMaps maps;
    set_lookups(options, {.k = 50, .caustic_k = 50, .radius = 1, .caustic_radius = 1}, maps);
    Moments m;
    for (int i = 0; i < n; ++i)
        m.add(double{map.irradiance(point_at({x, 1 + 2.2 * i, 0}, {0, 0, 1}), {0, 0, 1}, maps.global_lookup).E.g});
    return m;
}

struct Row {
    double wall, x, value;
};

void expect_rows(const PhotonOptions& options, std::initializer_list<Row> rows) {
    for (const auto& [wall, x, value] : rows) {
        const Moments m = floor_by_a_wall(options, wall, x);
        EXPECT_GT(m.p_value(value), 1e-4) << m.mean() << " +- " << m.standard_error() << ", expected " << value;
        EXPECT_LT(m.p_value(value * 1.03), 1e-3) << "3 % would be seen";
    }
}

// The table of section 1.4 of the report's checklist: dark edges and what the report's rule makes of them.
TEST(ReportMode, HasTheEdgesThatWereMeasured) {
    expect_rows(report(), {{1, 0, 1}, {1, 0.25, 1.126}, {1, 0.5, 1.179}});
    expect_rows(report(), {{0.2, 0.5, 0.879}, {5, 0.5, 2.68}});
}

TEST(ReportMode, WithoutItsEdgeRuleHasDarkEdges) {
    PhotonOptions options = report();
    options.edge = EdgeRule::none;
    expect_rows(options, {{1, 0, 0.5}, {1, 0.5, 0.805}});
}

/// Irradiance of radiance L(d) by the template of these options, of the true one.
template <class Radiance>
double by_template(const PhotonOptions& options, double truth, const Radiance& radiance) {
    const Hemisphere h = tune(options, nullptr, 0).hemisphere;
    constexpr std::uint32_t seeds = 400;
    double sum = 0;
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        std::vector<HemisphereRay> rays;
        for (int j = 0, i = 0; j < h.rings; ++j)
            for (int k = 0; k < h.sectors; ++k, ++i) {
                Sampler sampler(seed, Purpose::test, 0, static_cast<std::uint32_t>(i));
                const Vec3 d = h.direction(j, k, sampler.next2());
                rays.push_back({Rgb(radiance(d)), 1, d});
            }
        sum += double{read_hemisphere(h, {}, rays).E.g};
    }
    return sum / seeds / truth;
}

// The table of section 1.3: light that falls with the cosine, a band at the horizon, a cap about the zenith.
TEST(ReportMode, HasTheHemisphereThatWasMeasured) {
    const double pi_d = std::numbers::pi;
    const auto expect = [&](const PhotonOptions& options, std::array<double, 3> wanted) {
        EXPECT_NEAR(by_template(options, 2 * pi_d / 3, [](Vec3 d) { return d.z; }), wanted[0], 0.004);
        EXPECT_NEAR(by_template(options, pi_d / 4, [](Vec3 d) { return d.z < 0.5F ? 1.0F : 0.0F; }), wanted[1], 0.01);
        EXPECT_NEAR(by_template(options, pi_d / 4, [](Vec3 d) { return d.z > std::sqrt(0.75F) ? 1.0F : 0.0F; }),
                    wanted[2], 0.01);
    };
    PhotonOptions options = report();
    const Hemisphere h = tune(options, nullptr, 0).hemisphere;
    EXPECT_EQ(h.size(), 78);
    options.half_jitter = false;
    expect(options, {0.955, 1.333, 1.333});
    options.strata = Strata::solid_angle;
    expect(options, {0.750, 2.000, 0.534});
    options.strata = Strata::cosine;
    expect(options, {1.000, 0.999, 0.998});
    options.half_jitter = true;
    expect(options, {0.943, 1.333, 0.667});
}

// Notes [1], [6] and [10]: photons by faces, a cache point at every fourth, no light but what photons brought.
TEST(ReportMode, ShootsAndKeepsAsTheReportSays) {
    const Folder folder;
    folder.write("room.csg", cardioid::test::lit_room);
    const Outcome run = folder.call({"room.csg", "--photons", "--set", "photon.mode=report", "-s", "24", "--spp", "1",
                                     "-v", "--stats", "a.json", "--set", "photon.caustic_count=1000"});
    ASSERT_EQ(run.status, 0) << run.err;
    const json lighting = json::parse(folder.read("a.json"))["lighting"];
    EXPECT_EQ(lighting["photons emitted"], 10'000);
    const int stored = lighting["photons stored"], points = lighting["cache points"];
    EXPECT_NEAR(points, std::ceil(stored / 4.0), 0.002 * stored);
    EXPECT_NE(run.err.find("photon.count = 10000: 10,000 + "), std::string::npos) << run.err;
}

}  // namespace
}  // namespace cardioid::photon::test

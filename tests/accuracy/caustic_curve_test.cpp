/// The ridge of a caustic lies where geometry has it (A6).
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "rt_core/render/probe.hpp"
#include "tests/accuracy/lit_scene.hpp"

namespace cardioid::test {
namespace {

using Curve = Vec3d (*)(double);

/// Envelope of parallel light along +x in a mirrored circle of radius 1.
Vec3d nephroid(double t) {
    return {(3 * std::cos(t) - std::cos(3 * t)) / 4, (3 * std::sin(t) - std::sin(3 * t)) / 4, 0};
}
/// The same of light from (-1, 0).
Vec3d cardioid_curve(double t) {
    return {(2 * std::cos(t) - std::cos(2 * t)) / 3, (2 * std::sin(t) - std::sin(2 * t)) / 3, 0};
}

/// Off a curve by 3 % of the ring's radius, which is to be seen.
template <Curve curve>
Vec3d beside(double t) {
    const Vec3d along = normalize(curve(t + 1e-4) - curve(t - 1e-4));
    return curve(t) + Vec3d{-along.y, along.x, 0} * 0.03;
}

/// How far from the curve irradiance is the largest, on its normal at t.
double ridge_offset(const CommittedScene& scene, const LightingModule& lighting, Curve curve, double t) {
    constexpr double step = 0.002, most = 0.06;
    const Vec3d along = normalize(curve(t + 1e-4) - curve(t - 1e-4)), across{-along.y, along.x, 0};
    std::vector<ProbePoint> points;
    for (double offset = -most; offset <= most; offset += step)
        points.push_back({curve(t) + across * offset, {0, 0, 1}});
    Progress silent;
    const std::vector<Reading> found = probe(scene, lighting, points, {.noise = 0, .most_samples = 16}, silent);
    const auto brightest = std::max_element(found.begin(), found.end(),
                                            [](const Reading& a, const Reading& b) { return a.value.g < b.value.g; });
    return std::abs(static_cast<double>(brightest - found.begin()) * step - most);
}

void expect_ridge(const char* file, Curve curve, Curve wrong, std::initializer_list<double> places) {
    constexpr double radius = 0.01;
    const CommittedScene scene = commit(sample_scene(std::string("accuracy/caustics/") + file));
    Params options("test");
    options.set("indirect", std::string("none"));
    options.set("caustic_radius", radius);
    options.set("caustic_count", 1e6);
    const auto lighting = prepared_lighting("photon", scene, 1, nullptr, options);
    for (const double t : places) {
        EXPECT_LE(ridge_offset(scene, *lighting, curve, t), radius) << file << " at t = " << t;
        EXPECT_GT(ridge_offset(scene, *lighting, wrong, t), radius) << file << " at t = " << t;
    }
}

TEST(Caustics, OfParallelLightInARingFollowTheNephroid) {
    expect_ridge("ring_mirror.csg", nephroid, beside<nephroid>, {0.4, -0.6, 0.8, 1.0});
}

TEST(Caustics, OfALampOnARingFollowTheCardioid) {
    expect_ridge("cardioid.csg", cardioid_curve, beside<cardioid_curve>, {0.5, -0.8, 1.2, 1.6});
}

}  // namespace
}  // namespace cardioid::test

#include <gtest/gtest.h>
#include <numbers>

#include "tests/photon_map/planes.hpp"

namespace cardioid::photon::test {
namespace {

constexpr Vec3 up{0, 0, 1}, away{1, 0, 0};

/// Area of a disc of radius 1 about a point at x that lies right of x = 0.
double clipped_area(double x) {
    return x >= 1 ? std::numbers::pi : std::numbers::pi - std::acos(x) + x * std::sqrt(1 - x * x);
}

/// The half plane x >= 0, y in [0, length], with `density` photons a unit of area, and a wall on its edge if `wall` >
/// 0.
PhotonScene half_plane(double length, double density, double wall) {
    const auto l = static_cast<float>(length);
    PhotonScene scene(1);
    scene.add({}, {2.2F, 0, 0}, {0, l, 0}, up, density);
    scene.add({}, {0, l, 0}, {0, 0, 1.1F}, away, wall * density);
    return scene;
}

struct Row {
    double x, value;
};

void expect_mean(const Moments& m, double expected) {
    EXPECT_GT(m.p_value(expected), 1e-4) << m.mean() << " +- " << m.standard_error() << ", expected " << expected;
    EXPECT_LT(m.p_value(expected * 1.02), 1e-4) << "2 % would be seen";
}

/// Looks along the edge of the half plane, at each distance x, by a radius of 1 where irradiance is 1.
void expect_rows(EdgeRule edge, double wall, std::initializer_list<Row> rows) {
    constexpr int n = 500;
    const double density = 130 / (1 + wall / 3);
    const PhotonMap map = half_plane(2.2 * n + 2, density, wall).map(density);
    const LookupRule rule{.max_radius = 1, .fixed_radius = true, .kernel = Kernel::box, .edge = edge};
    for (const auto [x, value] : rows) {
        Moments m;
        for (int i = 0; i < n; ++i) m.add(double{map.irradiance(point_at({x, 1 + 2.2 * i, 0}, up), up, rule).E.g});
        expect_mean(m, value);
    }
}

// The figures are those of the table of section 1.4 of the report's checklist.

TEST(Edges, WithoutCorrectionAreDark) {
    for (const auto [x, value] : {Row{0, 0.5}, {0.25, 0.658}, {0.5, 0.805}, {0.75, 0.928}})
        EXPECT_NEAR(clipped_area(x) / std::numbers::pi, value, 1e-3);
    expect_rows(EdgeRule::none, 0, {{0, 0.5}, {0.25, 0.658}, {0.5, 0.805}, {0.75, 0.928}});
}

TEST(Edges, BeforeAnEquallyLitWallOvershootByTheReportsRule) {
    expect_rows(EdgeRule::report, 1, {{0, 1}, {0.25, 1.126}, {0.5, 1.179}, {0.75, 1.147}});
}

TEST(Edges, BeforeADarkWallStayDarkByTheReportsRule) {
    expect_rows(EdgeRule::report, 0.2, {{0, 0.6}, {0.25, 0.751}, {0.5, 0.879}, {0.75, 0.972}});
}

TEST(Edges, BeforeABrightWallShineByTheReportsRule) {
    expect_rows(EdgeRule::report, 5, {{0, 3}, {0.25, 3}, {0.5, 2.68}, {0.75, 2.02}});
}

TEST(Edges, OfATableAreNotCorrectedByTheReportsRule) {
    expect_rows(EdgeRule::report, 0, {{0, 0.5}, {0.25, 0.658}, {0.5, 0.805}, {0.75, 0.928}});
}

TEST(Edges, OfThreePlanesInACornerAreThreeQuartersByTheReportsRule) {
    constexpr int n = 500;
    constexpr double density = 100;
    PhotonScene scene(1);
    for (int i = 0; i < n; ++i) {
        const Vec3 corner{static_cast<float>(3 * i), 0, 0};
        const Vec3 x{1.2F, 0, 0}, y{0, 1.2F, 0}, z{0, 0, 1.2F};
        scene.add(corner, x, y, {0, 0, 1}, density);
        scene.add(corner, y, z, {1, 0, 0}, density);
        scene.add(corner, z, x, {0, 1, 0}, density);
    }
    const PhotonMap map = scene.map(density);
    const LookupRule rule{.max_radius = 1, .fixed_radius = true, .kernel = Kernel::box, .edge = EdgeRule::report};
    Moments m;
    for (int i = 0; i < n; ++i) m.add(double{map.irradiance(point_at({3.0 * i, 0, 0}, up), up, rule).E.g});
    expect_mean(m, 0.75);
}

/// What lookups of 50 photons say by the hull at a distance from the edge of that share of their mean radius.
Moments fifty(double share, double wall) {
    constexpr int n = 600;
    const double density = 50 / clipped_area(share);  // a clipped disc of radius 1 holds 50 photons
    const PhotonMap map = half_plane(2.2 * n + 2, density, wall).map(density);
    const LookupRule rule{.kernel = Kernel::box, .edge = EdgeRule::hull};
    Moments m;
    for (int i = 0; i < n; ++i) m.add(double{map.irradiance(point_at({share, 1 + 2.2 * i, 0}, up), up, rule).E.g});
    return m;
}

TEST(Edges, AreRightByTheHull) {
    for (const double x : {0.0, 0.1, 0.25, 0.5, 0.75, 1.2}) {
        const Moments m = fifty(x, x == 0.5 ? 5 : 0);
        EXPECT_NEAR(m.mean(), 1, 0.02) << "at " << x << ", +- " << m.standard_error();
        EXPECT_NEAR(m.deviation(), 0.163, 0.015);
    }
}

TEST(Edges, OfShadowsAreNotCarriedOnByTheHull) {
    const auto beside = [](double x) {  // lit where x > 0, looked up at x < 0
        constexpr int n = 300;
        constexpr double density = 50 / std::numbers::pi;
        const PhotonMap map = half_plane(3 * n + 2, density, 0).map(density);
        Moments hull, plain;
        for (int i = 0; i < n; ++i) {
            const SurfacePoint point = point_at({x, 1 + 3.0 * i, 0}, up);
            hull.add(double{map.irradiance(point, up, {.kernel = Kernel::box, .edge = EdgeRule::hull}).E.g});
            plain.add(double{map.irradiance(point, up, {.kernel = Kernel::box, .edge = EdgeRule::none}).E.g});
        }
        return std::pair(hull.mean(), plain.mean());
    };
    const auto [near_hull, near_plain] = beside(0.25);
    EXPECT_NEAR(near_hull, 1, 0.03) << "on the lit side it is even right";
    EXPECT_LT(near_plain, 0.7);
    for (const double x : {-0.25, -0.5}) {
        const auto [hull, plain] = beside(x);
        EXPECT_NEAR(hull, plain, 0.01) << x;
        EXPECT_LT(plain, 0.45);
    }
}

}  // namespace
}  // namespace cardioid::photon::test

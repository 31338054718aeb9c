#include <gtest/gtest.h>
#include <numbers>

#include "tests/photon_map/planes.hpp"

namespace cardioid::photon::test {
namespace {

constexpr Vec3 up{0, 0, 1};

/// An evenly lit plane, where lookups of discs of about k photons are far from any edge and from each other, as many as
/// show an error of 2 %. Irradiance is 1.
class EvenPlane {
public:
    explicit EvenPlane(double k)
        : rows_(static_cast<int>(std::sqrt(100'000 / k))), spacing_(3 * std::sqrt(k / std::numbers::pi)) {
        const auto side = static_cast<float>((rows_ + 1) * spacing_);
        PhotonScene scene(1);
        scene.add({}, {side, 0, 0}, {0, side, 0}, up, 1);  // photons are one a unit of area
        map_ = scene.map(1);
    }
    [[nodiscard]] Moments look(const LookupRule& rule) const {
        Moments m;
        for (int i = 1; i <= rows_; ++i)
            for (int j = 1; j <= rows_; ++j)
                m.add(double{map_.irradiance(point_at({i * spacing_, j * spacing_, 0}, up), up, rule).E.g});
        return m;
    }

private:
    int rows_;
    double spacing_;
    PhotonMap map_;
};

LookupRule plain(std::uint32_t k) { return {.k = k, .kernel = Kernel::box, .edge = EdgeRule::none}; }

void expect_mean(const Moments& m, double expected) {
    EXPECT_GT(m.p_value(expected), 1e-4) << m.mean() << " +- " << m.standard_error() << ", expected " << expected;
    EXPECT_LT(m.p_value(expected * 1.02), 1e-4) << "2 % would be seen";
}

TEST(Density, IsRightWithoutTheLastPhotonAndTooBrightByOneInAllOthersWithIt) {
    for (const std::uint32_t k : {10U, 50U, 100U}) {
        const EvenPlane plane(k);
        const Moments m = plane.look(plain(k));
        expect_mean(m, 1);
        EXPECT_NEAR(m.deviation(), 1 / std::sqrt(k - 2.0), 0.06 / std::sqrt(k)) << "k = " << k;
        LookupRule with_last = plain(k);
        with_last.count_last = true;
        expect_mean(plane.look(with_last), 1 + 1 / (k - 1.0));
    }
}

TEST(Density, IsRightWithEveryKernelAndRadius) {
    const EvenPlane plane(40);
    LookupRule rule = plain(40);
    for (const Kernel kernel : {Kernel::cone, Kernel::gauss, Kernel::epanechnikov, Kernel::biweight}) {
        rule.kernel = kernel;
        expect_mean(plane.look(rule), 1);
    }
    rule.max_radius = std::sqrt(40 * inv_pi);
    rule.fixed_radius = true;
    expect_mean(plane.look(rule), 1);
    // Fewer photons than wanted: the whole radius counts.
    expect_mean(plane.look({.k = 1000, .max_radius = rule.max_radius, .edge = EdgeRule::none}), 1);
}

TEST(Density, TellsItsOwnVariance) {
    for (const std::uint32_t k : {20U, 100U}) {
        PhotonScene scene(1);
        scene.add({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, up, 2000);
        const Estimate e = scene.map(2000).irradiance(point_at({}, up), up, plain(k));
        EXPECT_NEAR(double{e.variance.g / (e.E.g * e.E.g)}, 1 / (k - 1.0), 1e-5);
        EXPECT_EQ(e.k, k);
    }
}

TEST(Density, OfNoPhotonsIsBlack) {
    const Estimate e = PhotonMap().irradiance(point_at({}, up), up, {});
    EXPECT_EQ(e.E, Rgb());
    EXPECT_EQ(e.k, 0U);
}

TEST(Density, OfOnePhotonInSightIsItsFluxOverTheDisc) {
    PhotonScene scene(1);
    Photon photon{};
    photon.p = {0.5F, 0, 0};
    photon.n = encode_direction(up);
    photon.flux = encode_flux(Rgb(2), 1);
    const PhotonMap map(std::span(&photon, 1), {10, 20, 30}, 1);
    LookupRule rule = plain(50);
    rule.max_radius = 1;
    const Estimate e = map.irradiance(point_at({10, 20, 30}, up), up, rule);
    EXPECT_NEAR(double{e.E.g}, 2 / std::numbers::pi, 1e-6);
    EXPECT_EQ(e.k, 1U);
}

TEST(Density, OfPhotonsAllInOnePlaceIsFinite) {
    Photon photon{};
    photon.p = {0.5F, 0.25F, 0};
    photon.n = encode_direction(up);
    photon.flux = encode_flux(Rgb(1), 1);
    const PhotonMap map(std::vector<Photon>(100, photon), {}, 1);
    for (const EdgeRule edge : {EdgeRule::none, EdgeRule::hull, EdgeRule::report})
        EXPECT_TRUE(is_finite(map.irradiance(point_at({0.5, 0.25, 0}, up), up, {.edge = edge}).E));
}

TEST(Density, DoesNotDependOnTheUnitOfLength) {
    PhotonScene scene(1);
    scene.add({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, up, 2000);
    std::vector<Photon> photons = scene.map(1).photons();
    const PhotonMap metres(photons, {}, 1);
    for (Photon& photon : photons) photon.p *= 1024;
    const PhotonMap larger(photons, {}, 1024.0F * 1024);
    for (const EdgeRule edge : {EdgeRule::none, EdgeRule::hull, EdgeRule::report}) {
        const LookupRule rule{.edge = edge};
        const Estimate a = metres.irradiance(point_at({0.25, 0.5, 0}, up), up, rule);
        const Estimate b = larger.irradiance(point_at({256, 512, 0}, up), up, rule);
        EXPECT_EQ(a.E, b.E);
        EXPECT_EQ(a.radius * 1024, b.radius);
    }
}

TEST(Density, OfABallIsRightWhileItsRadiusIsAQuarterOfTheBalls) {
    constexpr double ball = 1, area = 4 * std::numbers::pi * ball * ball;
    Random random(5);
    Moments m;
    for (int i = 0; i < 100; ++i) {
        constexpr std::size_t n = 4000;
        std::vector<Photon> photons(n);
        for (Photon& photon : photons) {
            photon = {};
            photon.p = sample_sphere(random.next2());
            photon.n = encode_direction(photon.p);
            photon.flux = encode_flux(Rgb(1), 1);
        }
        const PhotonMap map(photons, {}, static_cast<float>(area / n));
        // k such that the chord of the gather is a quarter: the area it cuts off is that of the disc.
        for (int j = 0; j < 20; ++j) {
            const Vec3 top = sample_sphere(random.next2());
            const auto k = static_cast<std::uint32_t>(n * 0.25 * 0.25 / 4);
            m.add(double{map.irradiance(point_at(Vec3d(top), top), top, plain(k)).E.g});
        }
    }
    EXPECT_NEAR(m.mean(), 1, 0.01);
}

TEST(Density, OfPhotonsOnTheOtherSideIsBlack) {
    PhotonScene scene(1);
    scene.add({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, up, 2000);
    EXPECT_EQ(scene.map(2000).irradiance(point_at({}, up), -up, {}).k, 0U);
}

TEST(Density, LeavesPhotonsOfOtherRegionsOutOnRequest) {
    PhotonScene scene(1);
    scene.add({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, up, 2000);
    SurfacePoint point = point_at({}, up);
    point.id.region = 7;  // photons have 0
    EXPECT_GT(scene.map(2000).irradiance(point, up, {}).k, 0U);
    EXPECT_EQ(scene.map(2000).irradiance(point, up, {.same_region = true}).k, 0U);
}

// As the floor of a groove that is .3 % of the disc deep, where much light is caught.
TEST(Density, LeavesPhotonsOfADeeperFaceOut) {
    const auto E = [](double caught) {
        PhotonScene scene(1);
        scene.add({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, up, 2000);
        scene.add({-1, -1, -0.0015F}, {2, 0, 0}, {0, 2, 0}, up, caught);
        return scene.map(2000).irradiance(point_at({}, up), up, {.k = 8000, .max_radius = 0.5F}).E.g;
    };
    EXPECT_NEAR(E(0), 1, 0.1);
    EXPECT_NEAR(E(6000), E(0), 0.02);
}

TEST(Density, OfRadianceWeighsEachPhotonByItsDirection) {
    std::vector<Photon> photons(100);
    Random random;
    for (Photon& photon : photons) {
        photon = {};
        photon.p = {random.next() - 0.5F, random.next() - 0.5F, 0};
        photon.n = encode_direction(up);
        photon.wi = encode_direction(random.below(2) ? Vec3{1, 0, 0} : up);
        photon.flux = encode_flux(Rgb(1), 1);
    }
    const PhotonMap map(photons, {}, 1);
    const SurfacePoint point = point_at({}, up);
    const Rgb E = map.irradiance(point, up, {}).E;
    const auto even = map.radiance(point, up, {}, [](Vec3) { return Rgb(1); });
    const auto steep = map.radiance(point, up, {}, [](Vec3 wi) { return wi == up ? Rgb(1, 0, 0) : Rgb(); });
    EXPECT_EQ(even, E);
    EXPECT_GT(steep.r, 0.2F * E.r);
    EXPECT_LT(steep.r, 0.8F * E.r);
    EXPECT_EQ(steep.g, 0);
}

}  // namespace
}  // namespace cardioid::photon::test

#include "photon/map/photon_map.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <omp.h>

#include "rt_core/api/error.hpp"
#include "tests/photon_map/planes.hpp"

namespace cardioid::photon::test {
namespace {

std::vector<Photon> lit_walls(std::size_t n) {
    std::vector<Photon> photons = cloud_of(Cloud::walls, n, 1);
    for (std::size_t i = 0; i < n; ++i) photons[i].flux = encode_flux(Rgb(1 + static_cast<float>(i % 7)), 1);
    return photons;
}

bool same(const std::vector<Photon>& a, const std::vector<Photon>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Photon)) == 0;
}

TEST(PhotonMap, NeedsAtMostThirtyThreeBytesAndATenthAPhoton) {
    for (const std::size_t n : {20'000U, 100'000U, 150'000U, 200'000U}) {
        const PhotonMap map(lit_walls(n), {}, 1);
        EXPECT_LE(static_cast<double>(map.memory_bytes()) / static_cast<double>(n), 33.1) << n;
    }
}

TEST(PhotonMap, IsTheSameForAnyNumberOfThreads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    const PhotonMap alone(lit_walls(70'000), {}, 1);
    for (const int threads : {2, 7}) {
        omp_set_num_threads(threads);
        EXPECT_TRUE(same(PhotonMap(lit_walls(70'000), {}, 1).photons(), alone.photons()));
    }
    omp_set_num_threads(before);
}

TEST(PhotonMap, OfItsOwnPhotonsIsTheSame) {
    const PhotonMap once(lit_walls(20'000), {1, 2, 3}, 0.5F);
    const PhotonMap again(once.photons(), once.origin(), once.flux_scale());
    EXPECT_TRUE(same(once.photons(), again.photons()));
    for (const EdgeRule edge : {EdgeRule::none, EdgeRule::hull, EdgeRule::report}) {
        const LookupRule rule{.edge = edge, .least_cos = 0};
        const SurfacePoint point = point_at({1.5, 2.5, 3}, {0, 0, 1});
        EXPECT_EQ(once.irradiance(point, point.ng, rule).E, again.irradiance(point, point.ng, rule).E);
    }
}

TEST(PhotonMap, IsNotBlurredByAPhotonAtTheHorizon) {
    PhotonScene plane(1);
    plane.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 20'000);
    std::vector<Photon> photons = plane.map(1).photons();
    for (const bool spread : {false, true}) {
        const LookupRule rule{.spread = spread, .max_radius = 0.5F, .edge = EdgeRule::none};
        const SurfacePoint point = point_at({0.5, 0.5, 0}, {0, 0, 1});
        const auto found = [&] {
            PhotonMap map(photons, {}, 1);
            if (spread) map.spread(rule);
            return map.irradiance(point, point.ng, rule).E.g;
        };
        const float near = found();
        ASSERT_GT(near, 0);
        photons.push_back(photons.front());
        photons.back().p = {3e8F, -2e8F, 0};
        EXPECT_NEAR(found(), near, 1e-3F * near) << spread;
        photons.pop_back();
    }
}

TEST(PhotonMap, TellsFluxDirectionAndPlaceOfAPhoton) {
    Photon photon{};
    photon.p = {1, 2, 3};
    photon.flux = encode_flux(Rgb(1, 0.5F, 0.25F), 1);
    photon.wi = encode_direction({0, 1, 0});
    photon.n = encode_direction({0, 0, 1});
    const PhotonMap map(std::span(&photon, 1), {10, 20, 30}, 4);
    EXPECT_EQ(map.size(), 1U);
    EXPECT_EQ(map.flux(0), Rgb(4, 2, 1));
    EXPECT_EQ(map.direction(0), (Vec3{0, 1, 0}));
    EXPECT_EQ(map.position(0), (Vec3d{11, 22, 33}));
}

TEST(PhotonMap, RefusesAPhotonThatIsNowhere) {
    std::vector<Photon> photons = lit_walls(10);
    photons[3].p.y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(PhotonMap(photons, {}, 1), Error);
}

}  // namespace
}  // namespace cardioid::photon::test

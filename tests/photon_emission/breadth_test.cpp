#include "photon/propagation/breadth.hpp"

#include "glossy_kit.hpp"

namespace cardioid {
namespace {

using photon::Breadth;
using photon::decode_breadth;
using photon::encode_breadth;
using photon::traced_share;
using test::SceneKit;

TEST(Breadth, IsKeptToASixteenthOfAPowerOfTwo) {
    for (double sr = 4 * std::numbers::pi; sr > 1e-8; sr *= 0.83) {
        const float kept = decode_breadth(encode_breadth(static_cast<float>(sr)));
        EXPECT_LE(std::abs(std::log2(double{kept} / sr)), 1.0 / 16 + 1e-4) << sr;
    }
    EXPECT_EQ(encode_breadth(0), Breadth::none);
    EXPECT_EQ(encode_breadth(1e-20F), Breadth::none);
    EXPECT_EQ(encode_breadth(std::numeric_limits<float>::quiet_NaN()), Breadth::none);
    EXPECT_EQ(decode_breadth(Breadth::none), 0);
    EXPECT_NEAR(decode_breadth(encode_breadth(HUGE_VALF)), 4 * pi, 1e-4);
}

TEST(Breadth, LeavesSingleDirectionsToPhotonsAndWideLightToRays) {
    EXPECT_EQ(traced_share(1e30F, Breadth::none), 0);
    EXPECT_EQ(traced_share(0, encode_breadth(12)), 0);
    EXPECT_GT(traced_share(100, encode_breadth(1)), 0.999F);
    EXPECT_EQ(traced_share(HUGE_VALF, encode_breadth(1)), 1);
    EXPECT_LT(traced_share(1, encode_breadth(0.01F)), 0.01F);
    float last = 0;
    for (float pdf = 1e-3F; pdf < 1e3F; pdf *= 1.3F) {
        const float share = traced_share(pdf, encode_breadth(0.1F));
        EXPECT_GT(share, last);
        last = share;
    }
}

/// Photons on the plate that a mirror at y = 1 sent there, and the mean of their breadths [sr].
struct Arrived {
    double mean = 0;
    int n = 0;
};
Arrived arrived(SceneKit kit, const char* wall, std::vector<double> roughness) {
    test::add_wall(kit, kit.material("wall", wall, {{wall[0] == 'm' ? "reflectance" : "roughness", roughness}}));
    const photon::Shot shot = test::shoot(kit.commit(), 20'000, {}, photon::Keep::caustics);
    Arrived sum;
    for (const photon::Photon& p : shot.photons) {
        const Vec3d at = test::place(shot, p);
        if (std::abs(at.x) > 0.3 || std::abs(at.y) > 0.3 || at.z > 1e-3) continue;
        sum.mean += double{decode_breadth(p.breadth)};
        ++sum.n;
    }
    sum.mean /= sum.n;
    return sum;
}

SceneKit lit_by(const char* kind, std::initializer_list<std::pair<const char*, std::vector<double>>> values) {
    SceneKit kit = test::plate("diffuse", {{"reflectance", {0}}});
    kit.light(kind, values, test::towards_wall({0, 0, 1.5}));
    return kit;
}

TEST(Breadth, OfALampInAMirrorIsThatOfItsImage) {
    // 0.4 wide and high, 2 away and 1.5 up: seen at cos = 2 / 2.5.
    const Arrived area = arrived(lit_by("area_light", {{"size", {0.4, 0.4}}, {"power", {5}}}), "mirror", {1});
    EXPECT_GT(area.n, 30);
    EXPECT_NEAR(area.mean / (0.16 * 0.8 / 6.25), 1, 0.08);
    const Arrived ball = arrived(lit_by("sphere_light", {{"r", {0.2}}, {"power", {5}}}), "mirror", {1});
    EXPECT_GT(ball.n, 30);
    EXPECT_NEAR(ball.mean / (std::numbers::pi * 0.04 / 6.25), 1, 0.08);
    const Arrived spot = arrived(lit_by("spot_light", {{"intensity", {1}}, {"angle", {60}}}), "mirror", {1});
    EXPECT_GT(spot.n, 30);
    EXPECT_EQ(spot.mean, 0);
    // No ray meets a lamp that is not there to be seen.
    SceneKit hidden = lit_by("area_light", {{"size", {0.4, 0.4}}, {"power", {5}}});
    hidden.scene.lights.back().params.set("visible", ParamValue{.kind = ParamValue::Kind::boolean});
    const Arrived unseen = arrived(std::move(hidden), "mirror", {1});
    EXPECT_GT(unseen.n, 30);
    EXPECT_EQ(unseen.mean, 0);
}

TEST(Breadth, OfTheSunInAMirrorIsTheSuns) {
    SceneKit kit = test::plate("diffuse", {{"reflectance", {0}}});
    kit.light("sun", {{"direction", {0, 1, -1}}, {"irradiance", {1}}, {"angle", {4}}});
    const Arrived sun = arrived(std::move(kit), "mirror", {1});
    EXPECT_GT(sun.n, 10);
    EXPECT_NEAR(sun.mean / (2 * std::numbers::pi * (1 - std::cos(2 * std::numbers::pi / 180))), 1, 0.05);
}

TEST(Breadth, OfWhatRoughMetalPassesOnIsThatOfItsLobe) {
    const auto spot = [] { return lit_by("spot_light", {{"intensity", {1}}, {"angle", {80}}}); };
    const Arrived narrow = arrived(spot(), "conductor", {0.2}), wide = arrived(spot(), "conductor", {0.36});
    EXPECT_GT(narrow.n, 30);
    EXPECT_GT(wide.n, 10);
    // The peak goes as the fourth power of roughness.
    EXPECT_NEAR(wide.mean / narrow.mean, std::pow(1.8, 4), 3) << narrow.mean << " " << wide.mean;
}

}  // namespace
}  // namespace cardioid

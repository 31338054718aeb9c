/// Photons of a light bring the same irradiance as its direct sampling, and all of its power.
#include <gtest/gtest.h>

#include "make.hpp"
#include "statistics.hpp"

namespace cardioid::test {
namespace {

struct Case {
    const char* name;
    const char* kind;
    Values values;
    Affine to_world;
    bool even_flux = true;  ///< every photon carries the power
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

const std::vector<Case>& cases() {
    const Affine above = Affine::translation({0.2, -0.1, 1});
    static const std::vector<Case> all = {
        {"Rectangle", "area_light", {{"size", list({1.5, 0.7})}, {"power", list({1, 2, 3})}}, above},
        {"Disk", "disk_light", {{"r", number(0.6)}}, above},
        {"Ball", "sphere_light", {{"r", number(0.3)}, {"power", number(5)}}, above},
        {"Point", "point_light", {{"intensity", number(2)}}, above},
        {"Spot", "spot_light", {{"angle", number(50)}, {"inner", number(20)}}, above},
        {"SharpSpot", "spot_light", {{"angle", number(40)}, {"power", number(3)}}, above},
        {"Sun", "sun", {{"direction", list({0.3, 0.2, -1})}, {"angle", number(30)}}, {}},
        {"ParallelSun", "sun", {{"direction", list({0.3, 0.2, -1})}, {"angle", number(0)}}, {}},
        {"Sky", "sky", {}, {}},
        {"CieSky", "sky", {{"cie", number(13)}, {"elevation", number(25)}}, {}, false},
        {"Studio", "sky", {{"radiance", text("studio")}}, {}, false},
    };
    return all;
}

class Emission : public testing::TestWithParam<Case> {
protected:
    void SetUp() override {
        light_ = make_light(GetParam().kind, GetParam().values, GetParam().to_world);
        light_->prepare({0.1, 0.1, 0}, 2);
        light_->set_face({4, 2});
    }
    std::unique_ptr<Light> light_;
};
INSTANTIATE_TEST_SUITE_P(Lights, Emission, testing::ValuesIn(cases()), [](const auto& c) { return c.param.name; });

constexpr double half = 1.3;  ///< of the square on the plane z = 0 that catches light from above

TEST_P(Emission, BringsTheIrradianceOfDirectSampling) {
    constexpr int n = 500'000;
    Random random;
    double photons = 0, photons2 = 0, direct = 0, direct2 = 0;
    for (int i = 0; i < n; ++i) {
        const Vec2 u_place = random.next2();
        const LightEmission e = light_->emit(u_place, random.next2());
        if (e.ray.d.z >= 0) continue;
        const Vec3d hit = e.ray.o - e.ray.d * (e.ray.o.z / e.ray.d.z);
        if (std::abs(hit.x) > half || std::abs(hit.y) > half) continue;
        photons += double{e.flux.r}, photons2 += double{e.flux.r} * double{e.flux.r};
    }
    for (int i = 0; i < n; ++i) {
        const Vec2d at = Vec2d(random.next2()) * (2 * half) - Vec2d{half, half};
        const LightSample s = light_->sample({at.x, at.y, 0}, random.next2());
        if (!(s.pdf > 0)) continue;
        const double flux = double{s.L.r} * std::max(0.0, double{s.wi.z}) / double{s.pdf} * 4 * half * half;
        direct += flux, direct2 += flux * flux;
    }
    const double a = photons / n, b = direct / n;
    const double sd = std::sqrt((photons2 / n - a * a + direct2 / n - b * b) / n);
    EXPECT_LT(std::abs(a - b), 4 * sd) << a << " by photons, " << b << " directly";
    EXPECT_GT(0.02 * b, 4 * sd);  // so an error of 2 % would be seen
}

TEST_P(Emission, CarriesItsPower) {
    Random random;
    double sum = 0;
    constexpr int n = 20'000;
    const double power = double{light_->power().g};
    for (int i = 0; i < n; ++i) {
        const Vec2 u_place = random.next2();
        const LightEmission e = light_->emit(u_place, random.next2());
        sum += double{e.flux.g};
        EXPECT_NEAR(length(e.ray.d), 1, 1e-6);
        if (GetParam().even_flux) {
            ASSERT_NEAR(double{e.flux.g}, power, 1e-5 * power);
        }
    }
    EXPECT_NEAR(sum / n, power, 1e-3 * power);
}

TEST(EmissionOfLamps, StartsOnTheirOwnFaceOutwards) {
    for (const char* kind : {"area_light", "disk_light", "sphere_light"})
        for (const bool visible : {true, false}) {
            Values values = {{"visible", truth(visible)}};
            values.insert(kind[0] == 'a' ? std::pair{"size", list({2, 2})} : std::pair{"r", number(1)});
            const auto light = make_light(kind, values, Affine::translation({0, 0, 5}));
            EXPECT_EQ(light->shape().has_value(), visible);
            light->set_face({7, 0});
            Random random;
            for (int i = 0; i < 1000; ++i) {
                const Vec2 u_place = random.next2();
                const LightEmission e = light->emit(u_place, random.next2());
                EXPECT_EQ(e.ray.from.region, visible ? 7 : FaceId::none);
                const Vec3 normal = kind[0] == 's' ? Vec3(e.ray.o - Vec3d{0, 0, 5}) : Vec3{0, 0, -1};
                EXPECT_GE(dot(Vec3(e.ray.d), normal), -1e-6F);
                EXPECT_EQ(light->emitted(e.ray.o, normal, Vec3(e.ray.d)), Rgb(1));
                EXPECT_EQ(light->emitted(e.ray.o, normal, -Vec3(e.ray.d)), Rgb{});
            }
        }
}

TEST(EmissionOfFarLights, StartsOutsideTheSceneAndPassesIt) {
    for (const char* kind : {"sun", "sky"}) {
        Values values;
        if (kind[1] == 'u') values = {{"direction", list({1, 1, -1})}};
        const auto light = make_light(kind, values);
        EXPECT_TRUE(is_black(light->power()));  // before it knows the scene
        const Vec3d centre{10, 20, 30};
        light->prepare(centre, 3);
        Random random;
        for (int i = 0; i < 1000; ++i) {
            const Vec2 u_place = random.next2();
            const Ray ray = light->emit(u_place, random.next2()).ray;
            EXPECT_GE(length(ray.o - centre), 3 * (1 - 1e-6));
            EXPECT_LE(length(cross(ray.d, centre - ray.o)), 3 * (1 + 1e-5));
            EXPECT_GT(dot(ray.d, centre - ray.o), 0);
        }
    }
}

}  // namespace
}  // namespace cardioid::test

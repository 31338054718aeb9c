/// Lights draw directions with the density they say, and give the light of the closed forms (accuracy of 0.3 %).
#include <gtest/gtest.h>

#include "make.hpp"
#include "statistics.hpp"

namespace cardioid::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

Affine turned_about_x(double angle) {
    return {{Vec3d{1, 0, 0}, {0, std::cos(angle), -std::sin(angle)}, {0, std::sin(angle), std::cos(angle)}}, {}};
}

void expect_light_density(const Light& light, Vec3d p, const Bins& bins = {}) {
    expect_density(
        [&](Random& random) {
            const LightSample s = light.sample(p, random.next2());
            EXPECT_NEAR(length(s.wi), s.pdf > 0 && !is_black(s.L) ? 1 : length(s.wi), 1e-5F);
            return is_black(s.L) ? Vec3{} : s.wi;
        },
        [&](Vec3 wi) { return double{light.pdf(p, wi)}; }, bins);
}

TEST(LightSampling, OfARectangleHasItsDensity) {
    const auto light = make_light("area_light", {{"size", list({2, 1})}}, Affine::translation({0.3, 0.1, 1}));
    expect_light_density(*light, {0, 0, 0});
    expect_light_density(*light, {4, 1, -2}, {Frame(normalize(Vec3{-3.7F, -0.9F, 3})), 0.9});
}

TEST(LightSampling, OfAFarRectangleHasItsDensity) {
    const auto light = make_light("area_light", {{"size", list({2, 1})}});
    const Vec3d p{20, 10, -60};
    expect_light_density(*light, p, {Frame(normalize(Vec3(-p))), 1 - 5e-4});
}

TEST(LightSampling, OfAParallelogramHasItsDensity) {
    Affine sheared = Affine::translation({0, 0, 2});
    sheared.row[0].y = 0.8;
    const auto light = make_light("area_light", {{"size", list({2, 2})}}, sheared);
    expect_light_density(*light, {0.5, 0, 0});
}

TEST(LightSampling, OfADiskHasItsDensity) {
    const auto light = make_light("disk_light", {{"r", number(1)}}, Affine::translation({0.5, 0, 1.5}));
    expect_light_density(*light, {0, 0, 0});
}

TEST(LightSampling, OfASphereHasItsDensity) {
    const auto light = make_light("sphere_light", {{"r", number(1)}}, Affine::translation({0, 2, 1}));
    const Frame axis(normalize(Vec3{0, 2, 1}));
    expect_light_density(*light, {0, 0, 0}, {axis, 0.8});
    expect_light_density(*light, {0, 1, 0.45});  // near its surface: almost a hemisphere
}

TEST(LightSampling, OfTheSunHasItsDensity) {
    const auto wide = make_light("sun", {{"direction", list({1, 2, -3})}, {"angle", number(40)}});
    const Frame axis(normalize(Vec3{-1, -2, 3}));
    expect_light_density(*wide, {}, {axis, 0.9});
    const auto real = make_light("sun", {{"direction", list({1, 2, -3})}});
    expect_light_density(*real, {}, {axis, 1 - 1.2e-5});
}

TEST(LightSampling, OfSkiesHasItsDensity) {
    expect_light_density(*make_light("sky"), {});
    expect_light_density(*make_light("sky", {{"radiance", text("studio")}, {"rotation", number(30)}}), {});
    expect_light_density(*make_light("sky", {{"radiance", text("studio")}}, turned_about_x(1)), {});
    expect_light_density(*make_light("sky", {{"cie", number(12)}, {"elevation", number(20)}}), {});
    expect_light_density(*make_light("sky", {{"cie", number(1)}, {"rotation", number(50)}}, turned_about_x(1)), {});
}

/// Irradiance at p on a surface of normal n.
double irradiance(const Light& light, Vec3d p, Vec3 n, std::uint32_t samples = 1 << 14) {
    double sum = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
        Sampler sampler(3, Purpose::test, 0, i);
        const LightSample s = light.sample(p, sampler.next2());
        if (s.pdf > 0) sum += double{s.L.g} * std::max(0.0, double{dot(s.wi, n)}) / double{s.pdf};
    }
    return sum / samples;
}

/// Form factor from a point to a parallel rectangle of width a and depth b (over its height) with a corner above it.
double corner_factor(double a, double b) {
    const double x = std::sqrt(1 + a * a), y = std::sqrt(1 + b * b);
    return (a / x * std::atan(b / x) + b / y * std::atan(a / y)) / (2 * std::numbers::pi);
}

constexpr double accuracy = 0.003;  ///< of lamps over planes

TEST(Irradiance, UnderARectangleIsItsFormFactor) {
    for (const double height : {0.05, 0.5, 1.0, 4.0, 40.0}) {
        const auto light = make_light("area_light", {{"size", list({2, 1})}}, Affine::translation({0, 0, height}));
        const double wanted = std::numbers::pi * 4 * corner_factor(1 / height, 0.5 / height);
        const double got = irradiance(*light, {0, 0, 0}, {0, 0, 1});
        EXPECT_NEAR(got, wanted, accuracy * wanted) << height;
        EXPECT_GT(std::abs(got * 1.02 - wanted), accuracy * wanted);
        const double corner = std::numbers::pi * corner_factor(2 / height, 1 / height);
        EXPECT_NEAR(irradiance(*light, {1, 0.5, 0}, {0, 0, 1}), corner, accuracy * corner) << height;
    }
}

/// Mean form factor from a lamp of 1 x 1 to a square of 1 x 1 at `corner` with these edges and normal.
double square_factor(const Light& light, Vec3d corner, Vec3d x, Vec3d y, Vec3 n) {
    double sum = 0;
    constexpr std::uint32_t samples = 1 << 17;
    for (std::uint32_t i = 0; i < samples; ++i) {
        Sampler sampler(5, Purpose::test, 0, i);
        const Vec2d at(sampler.next2());
        const LightSample s = light.sample(corner + x * at.x + y * at.y, sampler.next2());
        if (s.pdf > 0) sum += double{s.L.r} * std::max(0.0, double{dot(s.wi, n)}) / double{s.pdf};
    }
    return sum / samples / std::numbers::pi;
}

TEST(Irradiance, BetweenSquaresIsTheirFormFactor) {
    const double distances[] = {.1, .5, 1, 2, 5, 10};
    const double factors[] = {.8269945224, .4152532836, .1998248957, .0685895888, .0124039773, .0031620568};
    for (int i = 0; i < 6; ++i) {
        const auto light =
            make_light("area_light", {{"size", list({1, 1})}}, Affine::translation({0, 0, distances[i]}));
        EXPECT_NEAR(square_factor(*light, {-0.5, -0.5, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), factors[i],
                    accuracy * factors[i]);
    }
    const auto ceiling = make_light("area_light", {{"size", list({1, 1})}}, Affine::translation({0, 0, 1}));
    EXPECT_NEAR(square_factor(*ceiling, {-0.5, -0.5, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}), .2000437761,
                accuracy * .2000437761);
}

TEST(Irradiance, UnderADiskIsItsClosedForm) {
    for (const double height : {0.3, 1.0, 7.0, 300.0}) {
        const double r = 0.5 * 2;
        const auto light = make_light("disk_light", {{"r", number(0.5)}},
                                      Affine::translation({0, 0, height}) * Affine::scaling({2, 2, 2}));
        const double wanted = std::numbers::pi * r * r / (r * r + height * height);
        EXPECT_NEAR(irradiance(*light, {0, 0, 0}, {0, 0, 1}), wanted, accuracy * wanted) << height;
    }
}

TEST(Irradiance, OfASphereIsItsClosedForm) {
    for (const double distance : {1.05, 2.0, 10.0, 1e4, 1e7})
        for (const double tilt : {0.0, 0.3}) {
            const auto light = make_light("sphere_light", {{"r", number(1)}}, Affine::translation({0, 0, distance}));
            if (tilt > 0 && distance < 2) continue;  // partly below the horizon
            const Vec3 n(static_cast<float>(std::sin(tilt)), 0, static_cast<float>(std::cos(tilt)));
            const double wanted = std::numbers::pi / (distance * distance) * std::cos(tilt);
            EXPECT_NEAR(irradiance(*light, {0, 0, 0}, n), wanted, accuracy * wanted) << distance;
        }
}

TEST(Irradiance, OfTheSunIsWhatWasAskedFor) {
    for (const double angle : {0.0, 1e-4, 0.53, 20.0, 180.0}) {
        const auto light =
            make_light("sun", {{"direction", list({0, 0, -2})}, {"irradiance", number(3)}, {"angle", number(angle)}});
        EXPECT_NEAR(irradiance(*light, {5, 6, 7}, {0, 0, 1}), 3, 3 * accuracy) << angle;
    }
}

TEST(Irradiance, OfAnEvenSkyIsPiTimesItsRadiance) {
    const auto light = make_light("sky", {{"radiance", number(2)}});
    EXPECT_NEAR(irradiance(*light, {}, normalize(Vec3{1, 2, 3})), 2 * std::numbers::pi, accuracy * 6);
}

TEST(Irradiance, OfAPointFallsWithTheSquareExactly) {
    const auto light = make_light("point_light", {{"intensity", number(1000)}}, Affine::translation({0, 0, 3}));
    for (const double d : {1e-3, 0.1, 3.0, 1e3}) {
        const LightSample s = light->sample({0, 0, 3 - d}, {});
        EXPECT_TRUE(s.delta);
        EXPECT_NEAR(double{s.L.r} * d * d, 1000, 1e-3);
        EXPECT_NEAR(s.distance, d, 1e-12 * d);
    }
    const double diagonal = std::sqrt(9 + 16), wanted = 1000 * 3 / std::pow(diagonal, 3);
    EXPECT_NEAR(irradiance(*light, {4, 0, 0}, {0, 0, 1}), wanted, 1e-5 * wanted);
    EXPECT_TRUE(is_black(light->sample({0, 0, 3}, {}).L));
}

TEST(Irradiance, OfASpotIsEvenInsideAndFallsSmoothly) {
    const auto light =
        make_light("spot_light", {{"intensity", number(10)}, {"angle", number(40)}, {"inner", number(20)}},
                   Affine::translation({0, 0, 1}));
    const auto at = [&](double angle) {
        const double x = std::tan(angle * degree);
        return double{light->sample({x, 0, 0}, {}).L.r} * (1 + x * x);
    };
    EXPECT_NEAR(at(0), 10, 1e-5);
    EXPECT_NEAR(at(19.99), 10, 1e-5);
    EXPECT_EQ(at(40.01), 0);
    const double middle = std::acos((std::cos(20 * degree) + std::cos(40 * degree)) / 2) / degree;
    EXPECT_NEAR(at(middle), 5, 1e-4);
    EXPECT_TRUE(is_black(light->sample({0, 0, 5}, {}).L));
}

TEST(LightSampling, GivesNothingBehindAndInside) {
    const auto rectangle = make_light("area_light", {{"size", list({1, 1})}});
    const auto disk = make_light("disk_light", {{"r", number(1)}});
    const auto ball = make_light("sphere_light", {{"r", number(1)}});
    for (const Light* light : {rectangle.get(), disk.get(), ball.get()})
        for (const Vec3d p : {Vec3d{0.2, 0, 0.5}, {0, 0, 0}, {0.1, 0.2, 0}}) {
            EXPECT_TRUE(is_black(light->sample(p, {0.3F, 0.6F}).L));
            EXPECT_EQ(light->pdf(p, {0, 0, -1}), 0);
            EXPECT_EQ(light->pdf(p, {0, 0, 1}), 0);
        }
    EXPECT_TRUE(is_black(rectangle->sample({5, 5, 0}, {0.3F, 0.6F}).L));  // in its own plane
}

TEST(LightSampling, IsTheSameInAModelOfAnyScale) {
    const char* kinds[] = {"area_light", "disk_light", "sphere_light"};
    for (const char* kind : kinds)
        for (const double scale : {1e-3, 1e3}) {
            const Values values = {kind[0] == 'a' ? std::pair{"size", list({1, 2})} : std::pair{"r", number(0.7)}};
            const Affine place = Affine::translation({0.3, 0.2, 2}), big = Affine::scaling({scale, scale, scale});
            const auto small = make_light(kind, values, place), scaled = make_light(kind, values, big * place);
            Random random;
            for (int i = 0; i < 200; ++i) {
                const Vec3d p{random.next(), random.next(), random.next()};
                const Vec2 u = random.next2();
                const LightSample a = small->sample(p, u), b = scaled->sample(p * scale, u);
                EXPECT_NEAR(length(a.wi - b.wi), 0, 1e-6F);
                EXPECT_NEAR(b.pdf, a.pdf, 1e-5F * a.pdf);
                EXPECT_NEAR(b.distance, a.distance * scale, 1e-9 * b.distance);
                EXPECT_EQ(a.L, b.L);
            }
            EXPECT_NEAR(double{scaled->power().r}, double{small->power().r} * scale * scale,
                        1e-5 * double{scaled->power().r});
        }
}

TEST(LightSampling, IsFiniteEverywhere) {
    const Affine place = Affine::translation({0, 0, 1});
    std::vector<std::unique_ptr<Light>> lights;
    lights.push_back(make_light("area_light", {{"size", list({1, 1})}}, place));
    lights.push_back(make_light("disk_light", {{"r", number(1)}}, place));
    lights.push_back(make_light("sphere_light", {{"r", number(0.5)}}, place));
    lights.push_back(make_light("point_light", {}, place));
    lights.push_back(make_light("spot_light", {{"angle", number(180)}}, place));
    lights.push_back(make_light("sky", {{"radiance", text("studio")}}));
    lights.push_back(make_light("sun", {{"direction", list({0, 0, -1})}}));
    constexpr float edge = 0x1.fffffep-1F;
    std::vector<Vec3d> places = {{0.5, 0.5, 1}, {0, 0, 1}, {0, 0, 0.5}, {0, 0, 1 - 1e-300}, {1e30, 1e30, -1e30}};
    for (const double height : {1e-6, 1e-12, 1e-16})
        for (const double x : {0.0, 0.5, 0.5 + 1e-9, 1.0}) places.push_back({x, 0.5, 1 - height});
    for (const auto& light : lights)
        for (const Vec3d p : places)
            for (const Vec2 u : {Vec2{0, 0}, {edge, edge}, {0.5F, 0.5F}, {0, edge}, {edge, 0}}) {
                const LightSample s = light->sample(p, u);
                EXPECT_TRUE(is_finite(s.wi) && is_finite(s.L) && std::isfinite(s.pdf) && !std::isnan(s.distance));
                EXPECT_TRUE(std::isfinite(light->pdf(p, is_black(s.L) ? Vec3{0, 0, 1} : s.wi)));
            }
}

}  // namespace
}  // namespace cardioid::test

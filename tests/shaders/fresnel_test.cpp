#include "shaders/optics/fresnel.hpp"

#include <gtest/gtest.h>

namespace cardioid::shaders {
namespace {

constexpr double degree = std::numbers::pi / 180;

struct Row {
    double eta;
    double at[6];  ///< 0, 30, 45, 60, 75, 85 degrees
    double outside, inside;
};
constexpr double angles_deg[] = {0, 30, 45, 60, 75, 85};
constexpr Row rows[] = {{1.333, {.020373, .021436, .027898, .059691, .212378, .583523}, .066406, .474591},
                        {1.5, {.04, .041523, .050240, .089187, .253061, .612800}, .091778, .596346},
                        {1.52, {.042580, .044144, .053045, .092483, .256715, .614923}, .094707, .608166}};

TEST(Fresnel, HasTheValuesOfTheBooks) {
    for (const Row& row : rows) {
        for (int i = 0; i < 6; ++i)
            EXPECT_NEAR(fresnel_dielectric(std::cos(angles_deg[i] * degree), row.eta), row.at[i], 1e-6)
                << row.eta << " at " << angles_deg[i];
        const double outside = diffuse_fresnel_outside(row.eta);
        EXPECT_NEAR(outside, row.outside, 1e-6);
        EXPECT_NEAR(diffuse_fresnel_inside(outside, row.eta), row.inside, 1e-6);
    }
    EXPECT_NEAR(fresnel_dielectric(1, 1.65), .060164, 1e-6);
}

TEST(Fresnel, InnerDiffuseReflectanceIsTheIntegralFromInside) {
    const double inside = diffuse_average([](double c) { return fresnel_dielectric(c, 1 / 1.5); });
    EXPECT_NEAR(inside, .596346, 2e-4);  // midpoints across the critical angle
}

TEST(Fresnel, IsTheSameFromBothSides) {
    for (double angle = 0; angle < 89; angle += 3.7) {
        const double sine_behind = std::sin(angle * degree) / 1.5;
        EXPECT_NEAR(fresnel_dielectric(std::cos(angle * degree), 1.5),
                    fresnel_dielectric(std::sqrt(1 - sine_behind * sine_behind), 1 / 1.5), 1e-12);
    }
}

TEST(Fresnel, ReflectsAllBeyondTheCriticalAngle) {
    EXPECT_EQ(fresnel_dielectric(std::cos(41.8104 * degree), 1 / 1.5), 1);
    EXPECT_LT(fresnel_dielectric(std::cos(41.8102 * degree), 1 / 1.5), 1);
    EXPECT_EQ(fresnel_dielectric(0, 1.5), 1);
    EXPECT_EQ(fresnel_dielectric(1, 1), 0);
}

TEST(Fresnel, ReflectsOnePolarisationAtBrewstersAngle) {
    const double brewster = 56.3099 * degree, ratio = (1 - 1.5 * 1.5) / (1 + 1.5 * 1.5);
    EXPECT_NEAR(fresnel_dielectric(std::cos(brewster), 1.5), ratio * ratio / 2, 2e-7);
}

TEST(Fresnel, GivesTheTransmittanceOfASlabByPolarisations) {
    const double all[] = {.91832, .91596, .90253, .84347, .61481, .24565};
    const double once[] = {.91665, 0, 0, .83186, .57531, .16335};
    for (int i = 0; i < 6; ++i) {
        const PolarisedReflectance r = fresnel_polarised(std::cos(angles_deg[i] * degree), 1.52);
        EXPECT_NEAR(((1 - r.s) / (1 + r.s) + (1 - r.p) / (1 + r.p)) / 2, all[i], 1e-5);
        const double first = ((1 - r.s) * (1 - r.s) + (1 - r.p) * (1 - r.p)) / 2;
        EXPECT_NEAR(once[i] > 0 ? first : 0, once[i], 1e-5);
    }
}

TEST(Fresnel, OfAConductorWithoutAbsorptionIsThatOfADielectric) {
    for (const double eta : {1.1, 1.5, 3.0})
        for (double c = 0; c <= 1; c += 0.05)
            EXPECT_NEAR(fresnel_conductor(c, eta, 0), fresnel_dielectric(c, eta), 1e-12);
}

TEST(Fresnel, OfAConductorHasItsClosedFormFromAbove) {
    const double eta = 0.428, k = 2.46;
    EXPECT_NEAR(fresnel_conductor(1, eta, k), ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k), 1e-12);
    EXPECT_NEAR(fresnel_conductor(0, eta, k), 1, 1e-12);
}

TEST(Refraction, ObeysSnellsLaw) {
    const Vec3 h = normalize(Vec3{0.1F, -0.2F, 1});
    for (const float eta : {1.5F, 1 / 1.5F, 1.0F}) {
        const Vec3 wo = normalize(Vec3{0.3F, 0.2F, 0.8F}), wi = refract(wo, h, eta);
        EXPECT_NEAR(length(wi), 1, 1e-6);
        EXPECT_NEAR(length(cross(wo, h)), eta * length(cross(wi, h)), 1e-6);
        EXPECT_NEAR(dot(cross(wo, h), wi), 0, 1e-6);
        EXPECT_LT(dot(wi, h), 0);
    }
    EXPECT_EQ(refract(normalize(Vec3{1, 0, 0.1F}), {0, 0, 1}, 1 / 1.5F), Vec3{});
}

}  // namespace
}  // namespace cardioid::shaders

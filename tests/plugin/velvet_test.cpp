#include <cmath>
#include <gtest/gtest.h>
#include <string_view>

#include "rt_core/plugin/registry.hpp"

namespace cardioid::test {
namespace {

/// The Bsdf of the sample plug-in, loaded as the program loads it.
class Velvet : public testing::Test {
protected:
    Velvet() : registry(make_registry()) {
        load_plugin(CARDIOID_PLUGIN_DIR "plugin_velvet.so", *registry);
        params.set("reflectance", Rgb(0.6F, 0.2F, 0.1F));
        params.set("sheen", Rgb(0.5F, 0.3F, 0.4F));
        params.set("sharpness", 5);
    }
    const Bsdf& bsdf() {
        shader = registry->shaders()[0].make({params, {}});
        return *shader->bsdf(SurfacePoint{}, memory);
    }

    std::unique_ptr<Registry> registry;
    Params params{"a.csg:1:1"};
    std::shared_ptr<const Shader> shader;
    BsdfMemory memory;
};

Vec3 direction(float z, float phi) {
    const float r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Midpoint rule over the upper hemisphere: integral of g(wi) over solid angle.
template <class Function>
double hemisphere_integral(Function&& g) {
    constexpr int rings = 2000, sectors = 8;
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j)
            sum +=
                g(direction((static_cast<float>(i) + 0.5F) / rings, 2 * pi * (static_cast<float>(j) + 0.5F) / sectors));
    return sum * 2 * std::numbers::pi / (rings * sectors);
}

TEST_F(Velvet, AlbedoIsTheIntegralOfF) {
    const Bsdf& velvet = bsdf();
    for (const float z : {0.05F, 0.3F, 0.7F, 1.0F}) {
        const Vec3 wo = direction(z, 1);
        const double integral = hemisphere_integral([&](Vec3 wi) { return double{velvet.f(wo, wi).r} * wi.z; });
        EXPECT_NEAR(integral, velvet.albedo(wo).diffuse.r, 1e-4) << z;
        EXPECT_GT(std::abs(integral - 1.02 * velvet.albedo(wo).diffuse.r), 1e-4) << z;
        EXPECT_LE(max_component(velvet.albedo(wo).total()), 1.0F);
    }
}

TEST_F(Velvet, PdfIntegratesToOneAndSamplesFollowIt) {
    const Bsdf& velvet = bsdf();
    const Vec3 wo = direction(0.4F, 2);
    EXPECT_NEAR(hemisphere_integral([&](Vec3 wi) { return velvet.pdf(wo, wi, Lobe::all); }), 1, 1e-4);
    // Mean of cos wi over samples against the same mean by quadrature, five standard errors apart at most.
    const double mean = hemisphere_integral([&](Vec3 wi) { return double{velvet.pdf(wo, wi, Lobe::all)} * wi.z; });
    const double square =
        hemisphere_integral([&](Vec3 wi) { return double{velvet.pdf(wo, wi, Lobe::all)} * wi.z * wi.z; });
    constexpr int n = 100'000;
    double sum = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        Sampler sampler(1, Purpose::test, i, 0);
        const float u_lobe = sampler.next();
        const BsdfSample s = velvet.sample(wo, u_lobe, sampler.next2());
        sum += s.wi.z;
        ASSERT_NEAR(length(s.wi), 1, 1e-5);
        ASSERT_FLOAT_EQ(s.pdf, velvet.pdf(wo, s.wi, Lobe::all));
        ASSERT_NEAR(s.weight.r, velvet.f(wo, s.wi).r * s.wi.z / s.pdf, 1e-4F);
    }
    const double sigma = std::sqrt((square - mean * mean) / n);
    EXPECT_NEAR(sum / n, mean, 4 * sigma);
    EXPECT_GT(std::abs(sum / n - 1.02 * mean), 4 * sigma);
}

TEST_F(Velvet, IsReciprocalAndTheSameOnBothSides) {
    const Bsdf& velvet = bsdf();
    const Vec3 a = direction(0.2F, 0.5F), b = direction(0.8F, 4);
    EXPECT_EQ(velvet.f(a, b), velvet.f(b, a));
    EXPECT_EQ(velvet.f(a, b), velvet.f({a.x, a.y, -a.z}, {b.x, b.y, -b.z}));
    EXPECT_EQ(velvet.f(a, -b), Rgb{});
}

TEST_F(Velvet, AWrongParameterIsAnErrorOfTheFileThatCrossesTheSharedObject) {
    params.set("sharpness", -1);
    try {
        bsdf();
        FAIL() << "taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_input);
        EXPECT_EQ(std::string_view(error.what()).find("a.csg:1:1: sharpness = -1 must be between 0 and 100"), 0U)
            << error.what();
    }
}

}  // namespace
}  // namespace cardioid::test

/// What is particular to each material.
#include <gtest/gtest.h>

#include "make.hpp"

#include "shaders/materials/diffuse.hpp"

namespace cardioid::test {
namespace {

SurfacePoint on_plane(Vec3d p = {}, Vec3 ng = {0, 0, 1}) {
    static const Medium air;
    SurfacePoint point;
    point.p = p, point.ng = ng, point.frame = Frame(ng);
    point.front = point.back = &air;
    return point;
}

Vec3 at(double angle, double azimuth = 0) {
    const double r = std::sin(angle);
    return Vec3(Vec3d{r * std::cos(azimuth), r * std::sin(azimuth), std::cos(angle)});
}

TEST(Phong, InTheReportsFormIsItsEquationSeven) {
    const auto shader = make_shader(
        "phong",
        {{"diffuse", number(0.4)}, {"specular", number(0.3)}, {"exponent", number(5)}, {"normalized", truth(false)}});
    BsdfMemory memory;
    const Bsdf* bsdf = shader->bsdf(on_plane(), memory);
    const Vec3 wo = at(0.5), wi = at(0.8, 2.5), mirrored{-wo.x, -wo.y, wo.z};
    const double wanted = 0.4 * std::cos(0.8) + 0.3 * std::pow(double{dot(mirrored, wi)}, 5);
    EXPECT_NEAR(bsdf->f(wo, wi).r * wi.z, wanted, 1e-5);
    EXPECT_EQ(bsdf->albedo(wo).diffuse, Rgb(0.4F));
    EXPECT_EQ(bsdf->albedo(wo).specular, Rgb(0.3F));
}

TEST(Phong, LobeReflectsTheShareItIsKnownFor) {
    // cos^n alpha cos theta integrates to 2 pi/(n + 2) from above; less of it is above the surface from aside.
    const auto share = [](double n, double angle_deg) {
        const auto shader =
            make_shader("phong", {{"diffuse", number(0)}, {"specular", number(1)}, {"exponent", number(n)}});
        BsdfMemory memory;
        return shader->bsdf(on_plane(), memory)->albedo(at(angle_deg * std::numbers::pi / 180)).specular.r;
    };
    for (const double n : {0.0, 1.0, 20.0, 1e4, 1e6}) EXPECT_NEAR(share(n, 0), 1, 2e-3) << n;
    EXPECT_NEAR(share(1, 80), .41, 5e-3);
    EXPECT_NEAR(share(1e6, 45), std::sqrt(0.5), 2e-3);
}

TEST(Phong, AttenuatesAsTheReportSays) {
    BsdfMemory memory;
    const auto abc = make_shader("phong", {{"attenuation", list({0.1, 1, 0.01})}});
    const Bsdf* bsdf = abc->bsdf(on_plane(), memory);
    // Times the inverse square that is there already: 1/(a + b d + c d^2).
    for (const double d : {0.1, 1.0, 16.0})
        EXPECT_NEAR(double{bsdf->attenuation(d)} / (d * d), 1 / (0.1 + d + 0.01 * d * d), 1e-5);
    EXPECT_EQ(bsdf->attenuation(std::numeric_limits<double>::infinity()), 1);
    EXPECT_EQ(bsdf->attenuation(0), 0);
    const auto p = make_shader("phong", {{"attenuation_p", number(1e-3)}});
    EXPECT_NEAR(p->bsdf(on_plane(), memory)->attenuation(0.1), 1 / 1.1, 1e-6);
    for (const char* kind : {"phong", "diffuse"})
        EXPECT_EQ(make_shader(kind)->bsdf(on_plane(), memory)->attenuation(3), 1);
}

TEST(Plastic, IsDarkerThanItsBodyOnlyByWhatTheBodyAbsorbs) {
    BsdfMemory memory;
    const auto albedo = [&](double body) {
        const auto shader = make_shader("plastic", {{"reflectance", number(body)}});
        return shader->bsdf(on_plane(), memory)->albedo({0, 0, 1}).total().r;
    };
    EXPECT_NEAR(albedo(0), 0.04, 1e-5);
    EXPECT_NEAR(albedo(1), 1, 1e-5);
    // (1 - .04)(1 - outside) r / (ior^2 (1 - r inside)) of the body, by the tabulated diffuse reflectances.
    EXPECT_NEAR(albedo(0.5), 0.04 + 0.96 * (1 - .091778) * 0.5 / (2.25 * (1 - 0.5 * .596346)), 1e-4);
}

TEST(Plastic, TakesGrazingLightLessByItsAcceptance) {
    BsdfMemory memory;
    const auto shader = make_shader("plastic", {{"reflectance", number(0.7)}});
    const Bsdf& bsdf = *shader->bsdf(on_plane(), memory);
    for (const double o : {0.1, 0.8, 1.5})
        for (const double i : {0.2, 0.9, 1.45})
            EXPECT_NEAR(bsdf.f(at(o), at(i)).r, bsdf.albedo(at(o)).diffuse.r * inv_pi * bsdf.diffuse_acceptance(at(i)),
                        1e-5)
                << o << " " << i;
    EXPECT_LT(bsdf.diffuse_acceptance(at(1.5)), 0.5F);
}

TEST(Conductor, HasTheColourOfItsMetal) {
    BsdfMemory memory;
    const auto seen = [&](const char* metal) {
        return make_shader("conductor", {{"metal", text(metal)}})->bsdf(on_plane(), memory)->albedo({0, 0, 1}).specular;
    };
    const Rgb gold = seen("gold"), silver = seen("silver"), copper = seen("copper");
    EXPECT_NEAR(gold.r, .924, 2e-3);
    EXPECT_NEAR(gold.b, .404, 2e-3);
    EXPECT_GT(min_component(silver), 0.97F);
    EXPECT_GT(copper.r, copper.g + 0.2F);
}

TEST(Conductor, LosesWhatItsDocumentationSaysWhenRough) {
    BsdfMemory memory;
    const auto share = [&](double roughness) {
        const auto shader =
            make_shader("conductor", {{"eta", number(1e-3)}, {"k", number(100)}, {"roughness", number(roughness)}});
        return shader->bsdf(on_plane(), memory)->albedo({0, 0, 1}).specular.r;
    };
    EXPECT_NEAR(share(0), 1, 1e-4);
    EXPECT_NEAR(share(0.3), 0.99, 5e-3);
    EXPECT_NEAR(share(0.5), 0.92, 5e-3);
    EXPECT_NEAR(share(1), 0.31, 5e-3);
}

TEST(Dielectric, TellsItsMedium) {
    const auto shader = make_shader("dielectric", {{"ior", number(1.52)},
                                                   {"transmittance", list({0.5, 1, 0.25})},
                                                   {"distance", number(10)},
                                                   {"priority", number(3)}});
    const Medium* medium = shader->interior();
    ASSERT_NE(medium, nullptr);
    EXPECT_EQ(medium->ior, 1.52F);
    EXPECT_EQ(medium->priority, 3);
    EXPECT_NEAR(exp(medium->absorption * -10).r, 0.5, 1e-6);
    EXPECT_EQ(medium->absorption.g, 0);
    EXPECT_NEAR(exp(medium->absorption * -10).b, 0.25, 1e-6);
    EXPECT_EQ(make_shader("dielectric", {{"absorption", list({0.1, 0.2, 0.3})}})->interior()->absorption,
              Rgb(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(make_shader("diffuse")->interior(), nullptr);
}

TEST(Dielectric, BendsByTheMediaOfThePoint) {
    const Medium water{1.333F}, glass{1.5F};
    SurfacePoint point = on_plane();
    point.front = &water, point.back = &glass;
    BsdfMemory memory;
    const auto shader = make_shader("dielectric", {{"ior", number(1.5)}});
    const Bsdf* bsdf = shader->bsdf(point, memory);
    const Vec3 wo = at(0.7);
    const BsdfSample through = bsdf->sample(wo, 0.99F, {});
    EXPECT_EQ(through.lobe, Lobe::specular | Lobe::transmitted);
    EXPECT_NEAR(1.333F * wo.x, -1.5F * through.wi.x, 1e-6F);
    EXPECT_NEAR(through.weight.r, 1.333F * 1.333F / (1.5F * 1.5F), 1e-5F);
    const Vec3 steep = -at(1.3);  // from inside, beyond the critical angle of 62.7 degrees
    const BsdfSample inner = bsdf->sample(steep, 0.99F, {});
    EXPECT_EQ(inner.lobe, Lobe::specular);
    EXPECT_EQ(inner.weight, Rgb(1));
    EXPECT_EQ(bsdf->albedo(steep).transmitted, Rgb{});
}

TEST(Dielectric, ReflectionAloneKeepsItsFresnelWeight) {
    SurfacePoint point = on_plane();
    const Medium glass{1.5F};
    point.back = &glass;
    BsdfMemory memory;
    const BsdfSample s = make_shader("dielectric")->bsdf(point, memory)->sample({0, 0, 1}, 0.9F, {}, Lobe::specular);
    EXPECT_NEAR(s.weight.r, 0.04, 1e-6);
}

TEST(Filter, LetsLightStraightThrough) {
    const auto shader = make_shader("filter", {{"reflectance", number(0.5)}, {"transmittance", list({0.2, 0.4, 1})}});
    EXPECT_TRUE(shader->filters());
    EXPECT_EQ(shader->straight_transmittance(on_plane(), {0, 0, 1}), Rgb(0.2F, 0.4F, 1));
    BsdfMemory memory;
    const Bsdf* bsdf = shader->bsdf(on_plane(), memory);
    const Vec3 wo = at(1);
    EXPECT_EQ(bsdf->sample(wo, 0.999F, {}).wi, -wo);
    EXPECT_EQ(bsdf->albedo(wo).diffuse, Rgb(0.4F, 0.3F, 0));
    EXPECT_FALSE(make_shader("diffuse")->filters());
}

float field(const Shader& checker, Vec3d p, Vec3 ng) {
    BsdfMemory memory;
    return checker.bsdf(on_plane(p, ng), memory)->albedo({0, 0, 1}).diffuse.r;
}

TEST(Checker, AlternatesInAllDirections) {
    const auto shader = make_shader("checker", {{"a", number(1)}, {"b", number(0)}, {"size", number(2)}});
    EXPECT_EQ(field(*shader, {1, 1, 1}, {0, 0, 1}), 1);
    EXPECT_EQ(field(*shader, {3, 1, 1}, {0, 0, 1}), 0);
    EXPECT_EQ(field(*shader, {1, 3, 1}, {0, 0, 1}), 0);
    EXPECT_EQ(field(*shader, {1, 1, 3}, {0, 0, 1}), 0);
    EXPECT_EQ(field(*shader, {-1, 1, 1}, {0, 0, 1}), 0);
    EXPECT_EQ(field(*shader, {-1, -1, 1}, {0, 0, 1}), 1);
}

TEST(Checker, KeepsTheFieldOfAPointOnItsEdge) {
    for (const double size : {2e-3, 2.0, 2e3}) {
        const auto shader = make_shader("checker", {{"a", number(1)}, {"b", number(0)}, {"size", number(size)}});
        for (const double noise : {-1e-7, -1e-12, 0.0, 1e-12, 1e-7}) {
            EXPECT_EQ(field(*shader, Vec3d{0.3, 0.4, noise} * size, {0, 0, 1}), 0);  // the field below, z in (-1, 0)
            EXPECT_EQ(field(*shader, Vec3d{0.3, 0.4, noise} * size, {0, 0, -1}), 1);
            EXPECT_EQ(field(*shader, Vec3d{3 + noise, 0.4, 0.2} * size, {1, 0, 0}), 1);
        }
    }
}

TEST(Checker, TakesOtherMaterialsByName) {
    const Params given = params({{"a", text("paper")}, {"b", text("foil")}});
    const auto find = [](std::string_view name) -> std::shared_ptr<const Shader> {
        if (name == "paper") return make_shader("diffuse", {{"reflectance", number(0.25)}});
        if (name == "foil") return make_shader("filter");
        if (name == "glass") return make_shader("dielectric");
        return nullptr;
    };
    for (const ShaderKind& kind : shaders::builtin_shaders()) {
        if (std::string(kind.name) != "checker") continue;
        const auto shader = kind.make({given, find});
        EXPECT_EQ(field(*shader, {0.5, 0.5, 0.5}, {0, 0, 1}), 0.25F);
        EXPECT_TRUE(shader->filters());
        EXPECT_EQ(shader->straight_transmittance(on_plane({0.5, 0.5, 0.5}), {0, 0, 1}), Rgb{});
        EXPECT_EQ(shader->straight_transmittance(on_plane({1.5, 0.5, 0.5}), {0, 0, 1}), Rgb(0.5F));
        const Params glass = params({{"a", text("glass")}}), none = params({{"b", text("nothing")}});
        EXPECT_NE(error_of([&] { kind.make({glass, find}); }).find("\"glass\""), std::string::npos);
        EXPECT_NE(error_of([&] { kind.make({none, find}); }).find("\"nothing\""), std::string::npos);
    }
}

}  // namespace
}  // namespace cardioid::test

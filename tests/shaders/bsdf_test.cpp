/// What holds for the Bsdf of every material.
#include <gtest/gtest.h>

#include "make.hpp"
#include "statistics.hpp"

namespace cardioid::test {
namespace {

struct Case {
    const char* name;
    const char* kind;
    Values values;
    float front = 1, back = 1;  ///< indices of the media on both sides
    bool lossless = false;      ///< albedo is 1 for the brightest channel
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {"Diffuse", "diffuse", {{"reflectance", list({0.9, 0.5, 0.1})}}},
        {"WhiteDiffuse", "diffuse", {{"reflectance", number(1)}}, 1, 1, true},
        {"Phong", "phong", {{"diffuse", list({0.6, 0.2, 0.2})}, {"specular", number(0.4)}, {"exponent", number(30)}}},
        {"BroadPhong", "phong", {{"diffuse", number(0)}, {"specular", number(1)}, {"exponent", number(1)}}},
        {"SharpPhong", "phong", {{"diffuse", number(0.1)}, {"specular", number(0.9)}, {"exponent", number(300)}}},
        {"Plastic", "plastic", {{"reflectance", list({0.8, 0.3, 0.1})}}},
        {"WhitePlastic", "plastic", {{"reflectance", number(1)}}, 1, 1, true},
        {"RoughPlastic", "plastic", {{"reflectance", list({0.8, 0.3, 0.1})}, {"roughness", number(0.4)}}},
        {"WhiteRoughPlastic", "plastic", {{"reflectance", number(1)}, {"roughness", number(0.6)}}, 1, 1, true},
        {"Mirror", "mirror", {}, 1, 1, true},
        {"Gold", "conductor", {{"metal", text("gold")}}},
        {"RoughGold", "conductor", {{"metal", text("gold")}, {"roughness", number(0.5)}}},
        {"RoughestSilver", "conductor", {{"metal", text("silver")}, {"roughness", number(1)}}},
        {"Glass", "dielectric", {}, 1, 1.5F, true},
        {"GlassInWater", "dielectric", {}, 1.333F, 1.5F, true},
        {"BubbleInGlass", "dielectric", {}, 1.5F, 1, true},
        {"NoBoundary", "dielectric", {{"roughness", number(0.3)}}, 1.5F, 1.5F, true},
        {"RoughGlass", "dielectric", {{"roughness", number(0.5)}}, 1, 1.5F},
        {"RoughGlassInWater", "dielectric", {{"roughness", number(0.6)}}, 1.333F, 1.5F},
        {"Emitter", "emitter", {}},
        {"Filter", "filter", {{"reflectance", list({1, 0.5, 0})}, {"transmittance", list({0.2, 0.6, 0.6})}}},
        {"Checker", "checker", {{"a", number(0.7)}, {"size", number(3)}}},
    };
    return all;
}

/// A material at a point of the plane z = 0 with its media on both sides.
class Fixture {
public:
    explicit Fixture(const Case& c) : shader_(make_shader(c.kind, c.values)), front_{c.front}, back_{c.back} {
        point_.ng = {0, 0, 1};
        point_.front = &front_, point_.back = &back_;
        bsdf_ = shader_->bsdf(point_, memory_);
    }
    const Bsdf& bsdf() const { return *bsdf_; }
    /// (index of wi's side / index of wo's side)^2: from radiance to light.
    float light_factor(Vec3 wo, Vec3 wi) const {
        if (wo.z * wi.z >= 0) return 1;
        const float ratio = wo.z > 0 ? back_.ior / front_.ior : front_.ior / back_.ior;
        return ratio * ratio;
    }

private:
    std::shared_ptr<const Shader> shader_;
    Medium front_, back_;
    SurfacePoint point_;
    BsdfMemory memory_;
    const Bsdf* bsdf_;
};

class EveryBsdf : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Materials, EveryBsdf, testing::ValuesIn(cases()), [](const auto& c) { return c.param.name; });

Vec3 seen_at(double cosine, double phi = 0.7) {
    const double r = std::sqrt(1 - cosine * cosine);
    return Vec3(Vec3d{r * std::cos(phi), r * std::sin(phi), cosine});
}
constexpr double cosines[] = {1, 0.7, 0.25, -0.5};

TEST_P(EveryBsdf, DrawsDirectionsWithItsDensity) {
    const Fixture fixture(GetParam());
    const Bsdf& bsdf = fixture.bsdf();
    if (bsdf.is_delta()) {
        EXPECT_EQ(bsdf.pdf(seen_at(0.7), seen_at(0.7)), 0);
        EXPECT_EQ(bsdf.f(seen_at(0.7), seen_at(0.7)), Rgb{});
        return;
    }
    constexpr Lobe scattering = Lobe::diffuse | Lobe::glossy | Lobe::transmitted;
    const auto expect = [&](Vec3 wo, Lobe which) {
        expect_density(
            [&](Random& random) {
                const float u = random.next();
                const BsdfSample s = bsdf.sample(wo, u, random.next2(), which);
                return s.is_delta() || s.pdf == 0 ? Vec3{} : s.wi;
            },
            [&](Vec3 wi) { return double{bsdf.pdf(wo, wi, which)}; });
    };
    expect(seen_at(0.8), Lobe::all);
    expect(seen_at(-0.3), scattering);
    if (bsdf.lobes() != Lobe::diffuse && !is_black(bsdf.albedo(seen_at(0.5)).diffuse))
        expect(seen_at(0.5), Lobe::diffuse);
}

/// Mean light that samples of the lobes `which` bring, by well-spread numbers.
Rgb mean_light(const Fixture& fixture, Vec3 wo, Lobe which, std::uint32_t n = 1 << 15) {
    double sum[3] = {0, 0, 0};
    for (std::uint32_t i = 0; i < n; ++i) {
        Sampler sampler(7, Purpose::test, 0, i);
        const float u = sampler.next();
        const BsdfSample s = fixture.bsdf().sample(wo, u, sampler.next2(), which);
        const Rgb light = s.weight * fixture.light_factor(wo, s.wi);
        sum[0] += double{light.r}, sum[1] += double{light.g}, sum[2] += double{light.b};
    }
    return {static_cast<float>(sum[0] / n), static_cast<float>(sum[1] / n), static_cast<float>(sum[2] / n)};
}

void expect_close(Rgb got, Rgb wanted, float tolerance, double cosine) {
    EXPECT_NEAR(got.r, wanted.r, tolerance) << "at cosine " << cosine;
    EXPECT_NEAR(got.g, wanted.g, tolerance) << "at cosine " << cosine;
    EXPECT_NEAR(got.b, wanted.b, tolerance) << "at cosine " << cosine;
}

TEST_P(EveryBsdf, SendsOnTheShareThatItsAlbedoSays) {
    const Fixture fixture(GetParam());
    for (const double cosine : cosines) {
        const Vec3 wo = seen_at(cosine);
        const Albedo albedo = fixture.bsdf().albedo(wo);
        const Rgb total = albedo.total();
        EXPECT_LE(max_component(total), 1 + 1e-5F);
        EXPECT_GE(std::min({min_component(albedo.diffuse), min_component(albedo.specular),
                            min_component(albedo.transmitted)}),
                  0);
        if (GetParam().lossless) {
            EXPECT_NEAR(max_component(total), 1, 1e-5F);
        }
        constexpr float tolerance = 3e-3F;
        const Rgb all = mean_light(fixture, wo, Lobe::all);
        expect_close(all, total, tolerance, cosine);
        if (max_component(total) > 0.3F) {
            EXPECT_GT(max_component(all * 1.02F), max_component(total) + tolerance);
        }
        expect_close(mean_light(fixture, wo, Lobe::diffuse), albedo.diffuse, tolerance, cosine);
        expect_close(mean_light(fixture, wo, Lobe::glossy | Lobe::specular), albedo.specular, tolerance, cosine);
    }
}

TEST_P(EveryBsdf, IntegratesToTheAlbedoOfItsBroadLobes) {
    const Fixture fixture(GetParam());
    const Bsdf& bsdf = fixture.bsdf();
    if (bsdf.is_delta()) return;
    for (const double cosine : cosines) {
        const Vec3 wo = seen_at(cosine);
        double sum = 0;
        constexpr int rows = 700, columns = 200;
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < columns; ++j) {
                const double theta = (i + 0.5) * std::numbers::pi / rows;
                const Vec3 wi = seen_at(std::cos(theta), (j + 0.5) * 2 * std::numbers::pi / columns);
                sum += std::sin(theta) * double{bsdf.f(wo, wi).r * std::abs(wi.z) * fixture.light_factor(wo, wi)};
            }
        const Albedo albedo = bsdf.albedo(wo);
        const bool glossy = any(bsdf.lobes() & Lobe::glossy);
        const float wanted = albedo.diffuse.r + (glossy ? albedo.specular.r + albedo.transmitted.r : 0);
        EXPECT_NEAR(sum * 2 * std::numbers::pi * std::numbers::pi / (rows * columns), wanted, 3e-3)
            << "at cosine " << cosine;
    }
}

TEST_P(EveryBsdf, TakesAllDiffuseLightThatItsAlbedoSays) {
    const Fixture fixture(GetParam());
    double sum = 0;
    constexpr int steps = 2000;
    for (int i = 0; i < steps; ++i) {
        const float cosine = std::sqrt((static_cast<float>(i) + 0.5F) / steps);
        sum += double{fixture.bsdf().diffuse_acceptance({std::sqrt(1 - cosine * cosine), 0, cosine})};
    }
    EXPECT_NEAR(sum / steps, 1, 2e-3);
}

TEST_P(EveryBsdf, WeighsSamplesByValueCosineAndDensity) {
    const Fixture fixture(GetParam());
    const Bsdf& bsdf = fixture.bsdf();
    Random random;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 wo = random.direction();
        const float u = random.next();
        const BsdfSample s = bsdf.sample(wo, u, random.next2());
        if (is_black(s.weight)) continue;
        EXPECT_NEAR(length(s.wi), 1, 1e-4F);
        EXPECT_EQ(any(s.lobe & Lobe::transmitted), wo.z * s.wi.z < 0);
        EXPECT_EQ(s.lobe & bsdf.lobes(), s.lobe);
        if (s.is_delta()) {
            EXPECT_EQ(s.pdf, 0);
            continue;
        }
        const float pdf = bsdf.pdf(wo, s.wi);
        EXPECT_NEAR(s.pdf, pdf, 2e-3F * pdf);
        const Rgb wanted = bsdf.f(wo, s.wi) * (std::abs(s.wi.z) / pdf);
        EXPECT_NEAR(s.weight.g, wanted.g, 2e-3F * wanted.g + 1e-6F);
    }
}

TEST_P(EveryBsdf, IsReciprocal) {
    const Fixture fixture(GetParam());
    const Bsdf& bsdf = fixture.bsdf();
    Random random;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 a = random.direction(), b = random.direction();
        const float there = bsdf.f(a, b).r * fixture.light_factor(a, b), back = bsdf.f(b, a).r;
        EXPECT_NEAR(there, back, 2e-3F * std::max(there, back) + 1e-6F);
    }
}

TEST_P(EveryBsdf, DrawsOnlyWhatIsAskedFor) {
    const Fixture fixture(GetParam());
    Random random;
    for (int flags = 0; flags < 16; ++flags)
        for (int i = 0; i < 50; ++i) {
            const auto which = static_cast<Lobe>(flags);
            const float u = random.next();
            const BsdfSample s = fixture.bsdf().sample(random.direction(), u, random.next2(), which);
            EXPECT_EQ(s.lobe & which, s.lobe);
            EXPECT_EQ(s.lobe == Lobe::none, is_black(s.weight));
        }
}

TEST_P(EveryBsdf, IsFiniteInEveryDirection) {
    const Fixture fixture(GetParam());
    const Bsdf& bsdf = fixture.bsdf();
    constexpr float edge = 0x1.fffffep-1F;
    const float heights[] = {0, -0.0F, 1e-45F, -1e-45F, 1e-30F, 1e-20F, -1e-8F, 1e-8F, 1e-4F, 0.5F, 1, -1, -0.5F};
    const float numbers[] = {0, 0x1p-24F, 0.25F, 0.5F, edge};
    for (const float zo : heights)
        for (const float zi : heights) {
            const Vec3 wo = seen_at(double{zo}), wi = seen_at(double{zi}, zi > 0 ? 0.7 + std::numbers::pi : 0.7);
            const Rgb f = bsdf.f(wo, wi);
            EXPECT_TRUE(is_finite(f) && min_component(f) >= 0) << zo << ' ' << zi;
            EXPECT_TRUE(is_finite(f * std::abs(wi.z)));
            const float pdf = bsdf.pdf(wo, wi);
            EXPECT_TRUE(std::isfinite(pdf) && pdf >= 0) << zo << ' ' << zi;
            EXPECT_TRUE(is_finite(bsdf.albedo(wo).total()));
        }
    for (const float zo : heights)
        for (const float u : numbers)
            for (const float x : numbers)
                for (const float y : numbers) {
                    const BsdfSample s = bsdf.sample(seen_at(double{zo}), u, {x, y});
                    EXPECT_TRUE(is_finite(s.weight) && min_component(s.weight) >= 0) << zo;
                    EXPECT_TRUE(is_finite(s.wi) && std::isfinite(s.pdf)) << zo;
                }
}

}  // namespace
}  // namespace cardioid::test

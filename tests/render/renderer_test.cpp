#include "rt_core/render/renderer.hpp"

#include <atomic>
#include <gtest/gtest.h>
#include <omp.h>

#include "scene_kit.hpp"

#include "rt_core/render/lighting/direct_lighting.hpp"

namespace cardioid {
namespace {

using test::SceneKit;

/// A ball of glass, one of rough metal, one matt, on a mirror floor, under a lamp and a sky.
SceneKit zoo() {
    SceneKit kit;
    const auto glass = kit.material("glass", "dielectric", {{"absorption", {0.1, 0.5, 0.9}}});
    const auto metal = kit.material("metal", "conductor", {{"roughness", {0.3}}});
    const auto shiny = kit.material("shiny", "plastic", {{"reflectance", {0.7, 0.2, 0.1}}});
    const auto mirror = kit.material("mirror", "mirror", {{"reflectance", {0.8}}});
    const auto foil = kit.material("foil", "filter", {{"reflectance", {0.2, 0.9, 0.2}}, {"transmittance", {0.5}}});
    kit.root(kit.ball({-2.2, 0, 1}, 1, glass));
    kit.root(kit.ball({0, 0, 1}, 1, metal));
    kit.root(kit.ball({2.2, 0, 1}, 1, shiny));
    kit.root(kit.box({-5, -5, -1}, {5, 5, 0}, mirror));
    kit.root(kit.box({-1, -2.1, 0}, {1, -2, 1}, foil));
    kit.root(kit.box({-5, 5, -1}, {5, 6, 5}, 0));
    kit.light("area_light", {{"size", {1, 1}}, {"radiance", {9}}}, Affine::translation({0, -2, 5}));
    kit.light("sky", {{"radiance", {0.3, 0.4, 0.5}}});
    kit.scene.cameras.push_back({});
    kit.scene.cameras[0].eye = {1, -9, 3};
    kit.scene.cameras[0].look_at = {0, 0, 1};
    return kit;
}

RenderSettings settings_of(const SceneKit& kit, int width, int height, int samples) {
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.samples = samples;
    if (!kit.scene.cameras.empty()) settings.camera = kit.scene.cameras[0];
    return settings;
}

RenderResult rendered(const CommittedScene& scene, const RenderSettings& settings) {
    const auto module = direct_lighting.make({}, 0);
    Progress progress;
    return render(scene, *module, settings, progress);
}

double mean(const Layer& layer) {
    double sum = 0;
    for (const float v : layer.pixels) sum += v;
    return sum / static_cast<double>(layer.pixels.size());
}

TEST(Renderer, GivesTheSamePictureForAnyNumberOfThreads) {
    const SceneKit kit = zoo();
    const CommittedScene scene = kit.commit();
    RenderSettings settings = settings_of(kit, 61, 43, 5);
    settings.layers = layer_names();
    const int threads = omp_get_max_threads();
    std::vector<Film> films;
    for (const int n : {1, 2, 7, 7}) {
        omp_set_num_threads(n);
        films.push_back(rendered(scene, settings).film);
    }
    omp_set_num_threads(threads);
    for (const Film& film : films)
        for (std::size_t i = 0; i < film.layers.size(); ++i)
            EXPECT_EQ(film.layers[i].pixels, films[0].layers[i].pixels) << film.layers[i].name;
}

TEST(Renderer, HasLayersThatSumToThePicture) {
    const SceneKit kit = zoo();
    RenderSettings settings = settings_of(kit, 61, 43, 9);
    settings.layers = {"direct", "indirect", "caustic", "specular", "emission"};
    const Film film = rendered(kit.commit(), settings).film;
    const auto& beauty = film.layer("")->pixels;
    for (std::size_t i = 0; i < beauty.size(); ++i) {
        float sum = 0;
        for (const std::string& name : settings.layers) sum += film.layer(name)->pixels[i];
        ASSERT_NEAR(sum, beauty[i], 1e-5 * std::max(1.0F, beauty[i]));
    }
    for (const char* name : {"direct", "indirect", "specular", "emission"})
        EXPECT_GT(mean(*film.layer(name)), 0) << name;
    settings.layers.clear();
    EXPECT_EQ(rendered(kit.commit(), settings).film.layers[0].pixels, beauty);
}

TEST(Renderer, CropsWithoutChangingAPixel) {
    const SceneKit kit = zoo();
    const CommittedScene scene = kit.commit();
    RenderSettings settings = settings_of(kit, 40, 30, 3);
    const Film whole = rendered(scene, settings).film;
    settings.crop = {7, 5, 30, 29};
    const Film crop = rendered(scene, settings).film;
    ASSERT_EQ(crop.width, 23);
    ASSERT_EQ(crop.height, 24);
    for (std::size_t y = 0; y < 24; ++y)
        for (std::size_t x = 0; x < 23 * 3; ++x)
            ASSERT_EQ(crop.layers[0].pixels[y * 69 + x], whole.layers[0].pixels[(y + 5) * 120 + 21 + x]);
}

TEST(Renderer, SeesTheSurfaceThroughAPixelCentreWithOneSample) {
    SceneKit kit;
    kit.root(kit.box({-10, 5, -10}, {10, 6, 10}, 0));
    kit.scene.cameras.push_back({});
    RenderSettings settings = settings_of(kit, 3, 3, 1);
    settings.camera.fov_deg = 90;
    settings.layers = {"depth", "normal", "albedo", "region"};
    const Film film = rendered(kit.commit(), settings).film;
    EXPECT_NEAR(film.layer("depth")->pixels[4], 5, 1e-6);
    EXPECT_NEAR(film.layer("depth")->pixels[0], 5 * std::sqrt(1 + 8.0 / 9), 1e-6);
    EXPECT_EQ(film.layer("normal")->pixels[13], -1);
    EXPECT_EQ(film.layer("albedo")->pixels[12], 0.5F);
    EXPECT_EQ(film.layer("region")->pixels[4], 0);
}

/// White walls and white solids under a sky of radiance 1 give 1 wherever no light is lost between diffuse surfaces.
TEST(Renderer, KeepsAFurnaceEvenThroughGlassMirrorsAndFilters) {
    SceneKit kit;
    const auto glass = kit.material("glass", "dielectric", {});
    const auto water = kit.material("water", "dielectric", {{"ior", {1.33}}});
    const auto mirror = kit.material("mirror", "mirror", {{"reflectance", {1}}});
    const auto foil = kit.material("foil", "filter", {{"reflectance", {1}}, {"transmittance", {0.5}}});
    kit.root(kit.ball({-2.2, 0, 0}, 1, glass));
    kit.root(kit.ball({-2.2, 0, 0}, 0.5, water));
    kit.root(kit.ball({0, 0, 0}, 1, mirror));
    kit.root(kit.ball({2.2, 0, 0}, 1, foil));
    kit.light("sky", {{"radiance", {1}}});
    kit.scene.cameras.push_back({});
    kit.scene.cameras[0].eye = {0, -9, 0};
    const RenderResult result = rendered(kit.commit(), settings_of(kit, 64, 32, 64));
    EXPECT_EQ(result.statistics.bad_samples, 0U);
    double worst = 0, outside = 0, left = 0;
    const Layer& picture = result.film.layers[0];
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const double v = picture.pixels[static_cast<std::size_t>(y * 64 + x) * 3];
            if (y < 4) outside = std::max(outside, std::abs(v - 1));
            if (x < 26) left = std::max(left, std::abs(v - 1));
            worst = std::max(worst, v - 1);
        }
    EXPECT_LT(outside, 1e-6);
    // Specular paths that only meet the sky carry exactly 1, but for Russian roulette.
    EXPECT_LT(left, 0.3);
    EXPECT_LT(worst, 0.3);
    EXPECT_GT(mean(picture), 0.93);
    EXPECT_LT(mean(picture), 1.001);
}

TEST(Renderer, AbsorbsInGlassByBeerAndLambert) {
    SceneKit kit;
    // Without an index to speak of, no light is reflected.
    const auto tint = kit.material("tint", "dielectric", {{"ior", {1.0000001}}, {"absorption", {0.1, 0.5, 2}}});
    kit.root(kit.box({-9, 0, -9}, {9, 1.5, 9}, tint));
    kit.light("sky", {{"radiance", {1}}});
    kit.scene.cameras.push_back({});
    kit.scene.cameras[0].eye = {0, -5, 0};
    RenderSettings settings = settings_of(kit, 1, 1, 1);
    const auto check = [&](double length) {
        const Film film = rendered(kit.commit(), settings).film;
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(film.layers[0].pixels[c], std::exp(-length * std::array{0.1, 0.5, 2.0}[c]), 1e-5);
    };
    check(1.5);
    // The eye may be within the glass.
    settings.camera.eye = {0, 0.5, 0};
    check(1);
}

TEST(Renderer, FollowsMirrorsWithoutASmallLimit) {
    // Two facing mirrors of reflectance 0.98, seen almost along their normal: the sky is hundreds of bounces away.
    SceneKit kit;
    const auto mirror = kit.material("mirror", "mirror", {{"reflectance", {0.99}}});
    kit.root(kit.box({-10, 1, -10}, {10, 2, 10}, mirror));
    kit.root(kit.box({-10, -2, -10}, {10, -1, 10}, mirror));
    kit.light("sky", {{"radiance", {1}}});
    kit.scene.cameras.push_back({});
    kit.scene.cameras[0].eye = {0, 0, 0};
    kit.scene.cameras[0].look_at = {0.04, 1, 0};
    kit.scene.cameras[0].fov_deg = 0.001;
    // From x = 0 to 10 in steps of 0.08 after the first of 0.04: 125 bounces.
    const Film film = rendered(kit.commit(), settings_of(kit, 16, 16, 64)).film;
    const double wanted = std::pow(0.99, 125);
    EXPECT_NEAR(mean(film.layers[0]), wanted, 0.03 * wanted);
}

TEST(Renderer, ShowsGlossyMetalWhatStandsAroundIt) {
    SceneKit kit;
    const auto metal = kit.material("metal", "conductor", {{"roughness", {0.2}}});
    kit.root(kit.box({-5, 3, -5}, {5, 4, 5}, metal));
    kit.root(kit.box({-50, -9, -50}, {50, -8, 50}, 0));
    kit.light("point_light", {{"intensity", {400}}}, Affine::translation({0, -6, 0}));
    RenderSettings settings = settings_of(kit, 8, 8, 64);
    settings.layers = {"indirect"};
    EXPECT_GT(mean(*rendered(kit.commit(), settings).film.layer("indirect")), 0.01);
}

TEST(Renderer, GivesTheSamePictureOfAModelOfAnySize) {
    const auto picture = [](double scale) {
        SceneKit kit;
        const auto glass = kit.material("glass", "dielectric", {{"absorption", {0.4 / scale}}});
        const auto metal = kit.material("metal", "conductor", {{"roughness", {0.3}}});
        const std::uint32_t block = kit.box(Vec3d{-1, -1, 0} * scale, Vec3d{1, 1, 2} * scale, 0);
        const std::uint32_t bite = kit.ball(Vec3d{1, -1, 2} * scale, scale, metal);
        kit.root(kit.scene.solids.add_node(SolidOp::subtract, {block, bite}));
        kit.root(kit.ball(Vec3d{2, -2, 0.7} * scale, 0.7 * scale, glass));
        kit.root(kit.box(Vec3d{-9, -9, -1} * scale, Vec3d{9, 9, 0} * scale, 0));
        kit.light("disk_light", {{"r", {scale}}, {"radiance", {5}}}, Affine::translation(Vec3d{0, -3, 6} * scale));
        kit.light("point_light", {{"intensity", {30 * scale * scale}}}, Affine::translation(Vec3d{5, -5, 5} * scale));
        const CommittedScene scene = kit.commit();
        RenderSettings settings = settings_of(kit, 48, 36, 4);
        settings.camera = fitted_camera({Vec3d{-2, -3, 0} * scale, Vec3d{3, 2, 2} * scale}, -60, 30, 40, 4.0 / 3);
        return rendered(scene, settings).film.layers[0].pixels;
    };
    const std::vector<float> wanted = picture(1);
    for (const double scale : {1e-3, 1e3}) {
        const std::vector<float> found = picture(scale);
        double difference = 0, sum = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            difference += std::abs(found[i] - wanted[i]);
            sum += wanted[i];
        }
        EXPECT_GT(sum, 100);
        EXPECT_LT(difference, 1e-5 * sum) << scale;
    }
}

TEST(Renderer, ReplacesBadSamplesByBlackAndNamesTheFirst) {
    /// Light that is not a number.
    class Broken final : public LightingModule {
        [[nodiscard]] Rgb indirect(const World&, const SurfacePoint& point, const Bsdf&, Vec3,
                                   Sampler&) const noexcept override {
            return Rgb(point.p.x > 0 ? std::numeric_limits<float>::quiet_NaN() : -1);
        }
    };
    SceneKit kit;
    kit.root(kit.box({-1, 5, -1}, {1, 6, 1}, 0));
    Progress progress;
    const RenderResult result = render(kit.commit(), Broken{}, settings_of(kit, 30, 30, 2), progress);
    EXPECT_GT(result.statistics.bad_samples, 100U);
    const auto [x, y] = result.statistics.first_bad_pixel;
    EXPECT_GT(x, 5);
    EXPECT_GT(y, 5);
    EXPECT_LT(y, 11);
    for (const float v : result.film.layers[0].pixels) EXPECT_EQ(v, 0);
}

TEST(Renderer, LeavesAllToAModuleThatFollowsPathsItself) {
    class Whole final : public LightingModule {
        [[nodiscard]] std::optional<LightParts> incoming(const World&, const EyeRay&,
                                                         Sampler&) const noexcept override {
            return LightParts{.indirect = Rgb(0.25F)};
        }
    };
    const SceneKit kit = zoo();
    Progress progress;
    RenderSettings settings = settings_of(kit, 9, 9, 2);
    settings.layers = {"indirect"};
    const Film film = render(kit.commit(), Whole{}, settings, progress).film;
    for (const float v : film.layers[0].pixels) EXPECT_EQ(v, 0.25F);
    EXPECT_EQ(film.layers[1].pixels, film.layers[0].pixels);
}

TEST(Renderer, AsksShadowPhotonsBeforeItTracesShadowRays) {
    class Shadows final : public LightingModule {
        [[nodiscard]] std::optional<float> shadow(const SurfacePoint&, std::size_t) const noexcept override {
            return 0.5F;
        }
    };
    SceneKit kit;
    kit.root(kit.box({-9, 5, -9}, {9, 6, 9}, 0));
    kit.light("point_light", {{"intensity", {1}}});
    const CommittedScene scene = kit.commit();
    const RenderSettings settings = settings_of(kit, 9, 9, 1);
    Progress progress;
    const RenderResult half = render(scene, Shadows{}, settings, progress), whole = rendered(scene, settings);
    EXPECT_EQ(half.statistics.shadow_rays, 0U);
    EXPECT_EQ(whole.statistics.shadow_rays, 81U);
    EXPECT_NEAR(mean(half.film.layers[0]), mean(whole.film.layers[0]) / 2, 1e-6);
}

/// Interrupts after so many calls.
class Impatient final : public Progress {
public:
    explicit Impatient(int calls) : calls_(calls) {}
    [[nodiscard]] bool interrupted() const noexcept override { return --calls_ < 0; }

private:
    mutable std::atomic<int> calls_;
};

TEST(Renderer, ReturnsWhatThereIsWhenInterrupted) {
    const SceneKit kit = zoo();
    const CommittedScene scene = kit.commit();
    const auto module = direct_lighting.make({}, 0);
    for (const int calls : {0, 3, 30}) {
        Impatient progress(calls);
        const RenderResult result = render(scene, *module, settings_of(kit, 64, 64, 1000), progress);
        EXPECT_TRUE(result.statistics.interrupted);
        EXPECT_LT(result.statistics.samples, 1000);
        for (const float v : result.film.layers[0].pixels) ASSERT_TRUE(std::isfinite(v));
        EXPECT_EQ(mean(result.film.layers[0]) > 0, calls > 0);
    }
}

TEST(Renderer, EndsInTime) {
    const SceneKit kit = zoo();
    RenderSettings settings = settings_of(kit, 32, 32, 0);
    settings.time_s = 0.2;
    const RenderResult result = rendered(kit.commit(), settings);
    EXPECT_GE(result.statistics.samples, 1);
    EXPECT_LT(result.statistics.seconds, 5);
    EXPECT_FALSE(result.statistics.interrupted);
}

TEST(Renderer, SpendsItsSamplesWhereTheNoiseIs) {
    const SceneKit kit = zoo();
    RenderSettings settings = settings_of(kit, 48, 48, 4000);
    settings.noise = 0.1;
    const CommittedScene scene = kit.commit();
    const RenderResult result = rendered(scene, settings);
    EXPECT_GE(result.statistics.samples, 8);
    EXPECT_LT(result.statistics.samples, 2000);
    // The same stop for any number of threads.
    const int threads = omp_get_max_threads();
    omp_set_num_threads(threads + 2);
    EXPECT_EQ(rendered(scene, settings).film.layers[0].pixels, result.film.layers[0].pixels);
    omp_set_num_threads(threads);
}

TEST(Renderer, CountsItsRays) {
    SceneKit kit;
    kit.root(kit.box({-9, 5, -9}, {9, 6, 9}, kit.material("mirror", "mirror", {})));
    const RenderStatistics s = rendered(kit.commit(), settings_of(kit, 20, 10, 4)).statistics;
    EXPECT_EQ(s.camera_rays, 800U);
    EXPECT_EQ(s.specular_rays, 800U);
    EXPECT_EQ(s.shadow_rays, 0U);
    EXPECT_EQ(s.samples, 4);
    EXPECT_GT(s.cpu_seconds, 0);
}

TEST(Renderer, ShowsViews) {
    SceneKit kit;
    kit.root(kit.box({-9, 5, -9}, {9, 6, 9}, 0));
    RenderSettings settings = settings_of(kit, 3, 3, 1);
    const CommittedScene scene = kit.commit();
    const auto centre = [&](const char* view) {
        settings.view = view;
        const Film film = rendered(scene, settings).film;
        return Rgb{film.layers[0].pixels[12], film.layers[0].pixels[13], film.layers[0].pixels[14]};
    };
    EXPECT_EQ(centre("normal"), (Rgb{0.5F, 0, 0.5F}));
    EXPECT_EQ(centre("albedo"), Rgb(0.5F));
    EXPECT_GT(centre("depth").r, 0);
    EXPECT_LT(centre("depth").r, 1);
    EXPECT_FALSE(is_black(centre("region")));
}

void expect_error(ErrorCode code, const std::string& part, auto&& change) {
    const SceneKit kit = zoo();
    RenderSettings settings = settings_of(kit, 8, 8, 1);
    change(settings);
    try {
        static_cast<void>(rendered(kit.commit(), settings));
        ADD_FAILURE() << "nothing thrown for " << part;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST(Renderer, RefusesWhatItCannotRender) {
    expect_error(ErrorCode::limit, "bytes", [](RenderSettings& s) { s.width = s.height = 1'000'000; });
    expect_error(ErrorCode::usage, "pixels", [](RenderSettings& s) { s.width = 0; });
    expect_error(ErrorCode::usage, "crop", [](RenderSettings& s) { s.crop = {4, 4, 4, 8}; });
    expect_error(ErrorCode::usage, "crop", [](RenderSettings& s) { s.crop = {0, 0, 9, 8}; });
    expect_error(ErrorCode::usage, "did you mean \"normal\"", [](RenderSettings& s) { s.layers = {"norml"}; });
    expect_error(ErrorCode::usage, "did you mean \"depth\"", [](RenderSettings& s) { s.view = "dept"; });
    expect_error(ErrorCode::usage, "samples", [](RenderSettings& s) { s.samples = 0; });
    expect_error(ErrorCode::bad_input, "eye", [](RenderSettings& s) { s.camera.look_at = s.camera.eye; });
}

}  // namespace
}  // namespace cardioid

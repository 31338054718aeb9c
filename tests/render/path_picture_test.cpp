#include <gtest/gtest.h>
#include <omp.h>

#include "path_kit.hpp"

#include "rt_core/render/renderer.hpp"

namespace cardioid {
namespace {

using test::SceneKit;

/// A room with a lamp, a ball of glass and one of mirror, and a diffuse box.
SceneKit room() {
    SceneKit kit;
    const auto wall = kit.material("wall", "diffuse", {{"reflectance", {0.7, 0.6, 0.4}}});
    const auto outer = kit.box({-1, -1, -1}, {5, 5, 4}, wall), inner = kit.box({0, 0, 0}, {4, 4, 3}, wall);
    kit.root(kit.scene.solids.add_node(SolidOp::subtract, {outer, inner}));
    kit.root(kit.ball({1.2, 2.5, 0.6}, 0.6, kit.material("glass", "dielectric", {})));
    kit.root(kit.ball({2.8, 3, 0.6}, 0.6, kit.material("mirror", "mirror", {})));
    kit.root(kit.box({1.6, 1.4, 0}, {2.2, 1.8, 0.8}, 0));
    kit.light("area_light", {{"size", {1.5, 1.5}}, {"radiance", {4}}}, Affine::translation({2, 2, 2.99}));
    kit.scene.cameras.push_back({});
    kit.scene.cameras[0].eye = {2, 0.1, 1.5};
    kit.scene.cameras[0].look_at = {2, 3, 1};
    kit.scene.cameras[0].fov_deg = 60;
    return kit;
}

RenderSettings settings_of(const SceneKit& kit, int edge, int samples) {
    RenderSettings settings;
    settings.width = settings.height = edge;
    settings.samples = samples;
    settings.camera = kit.scene.cameras[0];
    return settings;
}

RenderResult rendered(const CommittedScene& scene, const RenderSettings& settings) {
    Progress progress;
    const test::PathKit path(scene);
    return render(scene, path.module(), settings, progress);
}

TEST(PathPicture, IsTheSameForAnyNumberOfThreads) {
    const SceneKit kit = room();
    const CommittedScene scene = kit.commit();
    RenderSettings settings = settings_of(kit, 37, 5);
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

TEST(PathPicture, HasLayersThatSumToIt) {
    const SceneKit kit = room();
    RenderSettings settings = settings_of(kit, 40, 8);
    settings.layers = {"direct", "indirect", "caustic", "specular", "emission"};
    const Film film = rendered(kit.commit(), settings).film;
    const auto& beauty = film.layer("")->pixels;
    for (std::size_t i = 0; i < beauty.size(); ++i) {
        float sum = 0;
        for (const std::string& name : settings.layers) sum += film.layer(name)->pixels[i];
        ASSERT_NEAR(sum, beauty[i], 1e-5F * std::max(1.0F, beauty[i]));
    }
}

/// Root mean square over the pixels of the error relative to the luminance and a tenth of its mean.
double relative_error(const std::vector<float>& found, const std::vector<float>& truth) {
    const auto luminance_of = [](const std::vector<float>& pixels, std::size_t i) {
        return static_cast<double>(luminance({pixels[3 * i], pixels[3 * i + 1], pixels[3 * i + 2]}));
    };
    const std::size_t n = truth.size() / 3;
    double mean = 0, sum = 0;
    for (std::size_t i = 0; i < n; ++i) mean += luminance_of(truth, i) / static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double L = luminance_of(truth, i), error = luminance_of(found, i) - L;
        sum += error * error / (L * L + 0.01 * mean * mean);
    }
    return std::sqrt(sum / static_cast<double>(n));
}

TEST(PathPicture, ConvergesWithTheRootOfItsSamplesAndStopsAtTheNoiseAskedFor) {
    // Without the glass, whose caustics are rare and bright, so that a small picture is enough.
    SceneKit kit = room();
    kit.scene.solids.roots.erase(kit.scene.solids.roots.begin() + 1);
    const CommittedScene scene = kit.commit();
    RenderSettings settings = settings_of(kit, 24, 600);
    settings.seed = 9;
    const std::vector<float> truth = rendered(scene, settings).film.layers[0].pixels;
    settings.seed = 0;
    const auto error_of = [&](int samples, double noise) {
        settings.samples = samples, settings.noise = noise;
        return relative_error(rendered(scene, settings).film.layers[0].pixels, truth);
    };
    const double few = error_of(8, 0), more = error_of(32, 0);
    EXPECT_LT(more / few, 0.6);
    EXPECT_GT(more / few, 0.3);
    constexpr double wanted = 0.12;
    const double reached = error_of(0, wanted);
    EXPECT_LT(reached, wanted * 4 / 3);
    EXPECT_GT(reached, wanted * 2 / 3);
}

/// A Bsdf that draws directions of no finite weight.
class BrokenBsdf final : public Bsdf {
public:
    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse; }
    [[nodiscard]] Rgb f(Vec3, Vec3) const noexcept override { return {}; }
    [[nodiscard]] float pdf(Vec3, Vec3, Lobe) const noexcept override { return inv_pi; }
    [[nodiscard]] BsdfSample sample(Vec3, float, Vec2, Lobe) const noexcept override {
        return {{0, 0, 1}, Rgb(std::numeric_limits<float>::quiet_NaN()), inv_pi, Lobe::diffuse};
    }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return {}; }
};

class BrokenShader final : public Shader {
public:
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept override {
        return memory.make<BrokenBsdf>();
    }
};

TEST(PathPicture, CountsABadSampleInItsPixelAndSpreadsItNowhere) {
    const auto registry = make_registry();
    shaders::add_builtins(*registry);
    registry->add(ShaderKind{"broken", "no numbers", {}, [](const ShaderInputs&) -> std::shared_ptr<const Shader> {
                                 return std::make_shared<BrokenShader>();
                             }});
    SceneKit kit;
    kit.material("broken", "broken", {});
    kit.root(kit.box({-0.5, 5, -0.5}, {0.5, 6, 0.5}, 1));
    kit.light("sky", {{"radiance", {1}}});
    kit.scene.cameras.push_back({});
    kit.scene.cameras[0].fov_deg = 30;
    const CommittedScene scene(kit.scene, *registry, csg::compile, {.studio = false});
    const RenderResult result = rendered(scene, settings_of(kit, 16, 4));
    const auto& pixels = result.film.layers[0].pixels;
    std::size_t black = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 3) {
        ASSERT_TRUE(std::isfinite(pixels[i]));
        black += pixels[i] == 0 ? 1 : 0;
    }
    EXPECT_GT(black, 20U);
    EXPECT_EQ(pixels[0], 1);
    EXPECT_GE(result.statistics.bad_samples, 4 * black);
    EXPECT_LT(result.statistics.bad_samples, 4 * black + 4 * 40);
    EXPECT_GT(result.statistics.first_bad_pixel[1], 2);
    EXPECT_LT(result.statistics.first_bad_pixel[1], 8);
}

}  // namespace
}  // namespace cardioid

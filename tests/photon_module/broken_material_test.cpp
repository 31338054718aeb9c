#include <gtest/gtest.h>
#include <limits>
#include <mutex>

#include "photon/lighting/photon_lighting.hpp"
#include "tests/render/scene_kit.hpp"

namespace cardioid::test {
namespace {

/// A material whose arithmetic has gone wrong, as a plug-in's may.
class BrokenBsdf final : public Bsdf {
public:
    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse; }
    [[nodiscard]] Rgb f(Vec3, Vec3) const noexcept override { return Rgb(nan); }
    [[nodiscard]] float pdf(Vec3, Vec3, Lobe) const noexcept override { return nan; }
    [[nodiscard]] BsdfSample sample(Vec3, float, Vec2 u, Lobe) const noexcept override {
        return {sample_cosine_hemisphere(u), Rgb(nan), 1, Lobe::diffuse};
    }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return {.diffuse = Rgb(nan)}; }

private:
    static constexpr float nan = std::numeric_limits<float>::quiet_NaN();
};

class BrokenShader final : public Shader {
public:
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept override {
        return memory.make<BrokenBsdf>();
    }
};

/// Keeps the warnings.
class Listener final : public Progress {
public:
    void log(int level, std::string_view text) override {
        const std::lock_guard lock(mutex_);
        if (level == 0) warnings += std::string(text) + "\n";
    }
    std::string warnings;

private:
    std::mutex mutex_;
};

TEST(PhotonFaults, OfAMaterialThatGivesNoNumbersAreToldAndDarkenItAlone) {
    const auto registry = make_registry();
    shaders::add_builtins(*registry);
    registry->add(
        ShaderKind{"broken", "gives no numbers", {}, [](const ShaderInputs&) -> std::shared_ptr<const Shader> {
                       return std::make_shared<BrokenShader>();
                   }});
    SceneKit kit;
    const std::uint32_t white = kit.material("white", "diffuse", {{"reflectance", {0.7}}});
    const std::uint32_t broken = kit.material("broken", "broken", {});
    kit.root(kit.box({-1, -1, -0.1}, {1, 1, 0}, white));
    kit.root(kit.box({-1, 1, -0.1}, {1, 1.1, 2}, white));
    kit.root(kit.box({-1.1, -1, -0.1}, {-1, 1, 2}, broken));
    kit.light("point_light", {{"power", {10, 10, 10}}}, Affine::translation({0, 0, 1.5}));
    const CommittedScene world(kit.scene, *registry, csg::compile, {.studio = false});
    Params params;
    params.set("count", 20'000.0);
    const auto module = photon::photon_lighting.make(params, 1);
    Listener listener;
    module->prepare(world, nullptr, listener);
    EXPECT_NE(listener.warnings.find("photons ended because a material gave no finite value: check its parameters"),
              std::string::npos)
        << listener.warnings;
    const SurfacePoint floor = seen(world, {0.3, 0.3, 1}, {0, 0, -1});
    const WhiteBsdf bsdf;
    for (std::uint32_t i = 0; i < 20; ++i) {
        Sampler sampler(1, Purpose::test, 0, i);
        const Rgb L = module->indirect(world, floor, bsdf, {0, 0, 1}, sampler);
        EXPECT_TRUE(is_finite(L));
        EXPECT_GE(min_component(L), 0.0F);
    }
}

}  // namespace
}  // namespace cardioid::test

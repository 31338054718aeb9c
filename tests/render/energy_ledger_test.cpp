#include "rt_core/render/measure/energy_ledger.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include "scene_kit.hpp"

#include "rt_core/render/lighting/path_lighting.hpp"
#include "rt_core/render/probe.hpp"

namespace cardioid {
namespace {

using test::SceneKit;

const MaterialFlux& of(const EnergyLedger& ledger, const std::string& material) {
    static const MaterialFlux none;
    for (const MaterialFlux& m : ledger.absorbed)
        if (m.material == material) return m;
    return none;
}

/// Share of all light, all channels.
double share(const EnergyLedger& ledger, const Flux& flux) { return flux.sum() / ledger.emitted.sum(); }

/// A block of 4 x 4 x (2 + top) with a ball of radius 1 taken out at the origin; below top = 1 it is open.
SceneKit cavity(double reflectance, double top) {
    SceneKit kit;
    const std::uint32_t white = kit.material("wall", "diffuse", {{"reflectance", {reflectance}}});
    kit.root(kit.scene.solids.add_node(SolidOp::subtract,
                                       {kit.box({-2, -2, -2}, {2, 2, top}, white), kit.ball({}, 1, white)}));
    return kit;
}

/// A room of edge 1, each wall a material of its own, with a ball and a lamp in it.
SceneKit room() {
    SceneKit kit;
    const auto wall = [&](const char* name, double reflectance, Vec3d lo, Vec3d hi) {
        kit.root(kit.box(lo, hi, kit.material(name, "diffuse", {{"reflectance", {reflectance, 0.5, 0.3}}})));
    };
    wall("floor", 0.5, {-0.1, -0.1, -0.1}, {1.1, 1.1, 0});
    wall("ceiling", 0.8, {-0.1, -0.1, 1}, {1.1, 1.1, 1.1});
    wall("left", 0.2, {-0.1, -0.1, 0}, {0, 1.1, 1});
    wall("right", 0.9, {1, -0.1, 0}, {1.1, 1.1, 1});
    wall("front", 0.6, {0, -0.1, 0}, {1, 0, 1});
    wall("behind", 0.4, {0, 1, 0}, {1, 1.1, 1});
    kit.light("area_light", {{"size", {0.4, 0.3}}, {"radiance", {3, 2, 1}}}, Affine::translation({0.6, 0.5, 0.9}));
    return kit;
}

TEST(EnergyLedger, ClosesInClosedAndOpenScenes) {
    SceneKit closed = room();
    closed.root(closed.ball({0.3, 0.4, 0.3}, 0.2, closed.material("glass", "dielectric", {{"absorption", {1, 2, 3}}})));
    closed.root(closed.ball({0.7, 0.6, 0.3}, 0.2, closed.material("steel", "mirror", {{"reflectance", {0.9}}})));
    const EnergyLedger in = energy_ledger(closed.commit(), 0);
    EXPECT_LT(in.imbalance(), 1e-5);
    EXPECT_EQ(in.escaped.sum(), 0);
    EXPECT_GT(of(in, "glass").absorbed.sum(), 0);
    EXPECT_NEAR(in.emitted.sum(), in.power.sum(), 1e-5 * in.power.sum());

    SceneKit open = cavity(0.7, 0.5);
    open.root(open.box({-0.2, -0.2, 1}, {0.2, 0.2, 1.2}, open.material("glow", "emitter", {{"emission", {1, 2, 3}}})));
    open.light("sky", {{"radiance", {1, 1, 2}}});
    open.light("sun", {{"direction", {0, 0.5, -1}}, {"irradiance", {3}}});
    const EnergyLedger out = energy_ledger(open.commit(), 0);
    EXPECT_LT(out.imbalance(), 1e-5);
    EXPECT_GT(out.escaped.sum(), 0);
    EXPECT_NEAR(out.emitted.sum(), out.power.sum(), 0.003 * out.power.sum());
    EXPECT_TRUE(ledger_warnings(out).empty());
}

TEST(EnergyLedger, KnowsWhatLeavesAnIntegratingSphere) {
    // A port of share f = 0.02; f/(1 - rho (1 - f)) of the flux leaves.
    SceneKit kit = cavity(0.95, 1 - 2 * 0.02);
    kit.light("point_light", {{"intensity", {1}}});
    const EnergyLedger ledger = energy_ledger(kit.commit(), 0, 1 << 13);
    const double left = 0.02 / (1 - 0.95 * 0.98),
                 sigma = std::sqrt(left * (1 - left) / static_cast<double>(ledger.paths));
    EXPECT_LT(std::abs(share(ledger, ledger.escaped) - left), 3.9 * sigma);
    EXPECT_GT(std::abs(share(ledger, ledger.escaped) - left * 1.1), 3.9 * sigma);
    EXPECT_NEAR(share(ledger, of(ledger, "wall").absorbed), 1 - left, 0.02);
    EXPECT_NEAR(share(ledger, ledger.cut_off), 0, 0.01);
}

TEST(EnergyLedger, BooksWhatAMediumAbsorbs) {
    SceneKit kit;
    kit.root(kit.ball({}, 2, kit.material("fog", "dielectric", {{"ior", {1}}, {"absorption", {0.5, 0.25, 0}}})));
    kit.light("point_light", {{"intensity", {1}}});
    const EnergyLedger ledger = energy_ledger(kit.commit(), 0);
    const double each = ledger.power.channel[0];
    EXPECT_NEAR(ledger.escaped.channel[0], each * std::exp(-1.0), 1e-4 * each);
    EXPECT_NEAR(ledger.escaped.channel[1], each * std::exp(-0.5), 1e-4 * each);
    EXPECT_NEAR(of(ledger, "fog").absorbed.channel[1], each * (1 - std::exp(-0.5)), 1e-4 * each);
    EXPECT_NEAR(of(ledger, "fog").absorbed.channel[2], 0, 1e-4 * each);
}

TEST(EnergyLedger, SeesThatClearGlassKeepsNothing) {
    for (const double roughness : {0.0, 0.4}) {
        SceneKit kit;
        kit.root(kit.box({-2, -2, -2}, {2, 2, -1},
                         kit.material("glass", "dielectric", {{"ior", {1.5}}, {"roughness", {roughness}}})));
        // Lamps inside and outside: without the factor of radiance taken off, each crossing would be wrong by 2.25.
        kit.light("point_light", {{"intensity", {1}}}, Affine::translation({0, 0, -1.5}));
        kit.light("point_light", {{"intensity", {1}}}, Affine::translation({0, 0, 1}));
        const EnergyLedger ledger = energy_ledger(kit.commit(), 0);
        EXPECT_LT(ledger.imbalance(), 1e-5);
        const double absorbed = share(ledger, of(ledger, "glass").absorbed);
        if (roughness == 0)
            EXPECT_NEAR(absorbed, 0, 1e-6);
        else
            EXPECT_TRUE(absorbed > 0 && absorbed < 0.15) << absorbed;  // lost between facets
        EXPECT_TRUE(ledger_warnings(ledger).empty());
    }
}

TEST(EnergyLedger, EndsInAClosedRoomOfMirrors) {
    SceneKit kit;
    const std::uint32_t mirror = kit.material("mirror", "mirror", {{"reflectance", {1}}});
    kit.root(kit.scene.solids.add_node(SolidOp::subtract,
                                       {kit.box({-2, -2, -2}, {2, 2, 2}, mirror), kit.ball({}, 1, mirror)}));
    kit.light("point_light", {{"intensity", {1}}}, Affine::translation({0.2, 0.3, 0.1}));
    const EnergyLedger ledger = energy_ledger(kit.commit(), 0, 1 << 10);
    EXPECT_LT(ledger.imbalance(), 1e-5);
    EXPECT_NEAR(share(ledger, ledger.cut_off), 1, 1e-5);
}

TEST(EnergyLedger, IsTheSameForAnyNumberOfThreads) {
    const CommittedScene scene = room().commit();
    omp_set_num_threads(1);
    const EnergyLedger one = energy_ledger(scene, 3, 5000);
    omp_set_num_threads(3);
    const EnergyLedger three = energy_ledger(scene, 3, 5000);
    omp_set_num_threads(omp_get_num_procs());
    ASSERT_EQ(one.absorbed.size(), three.absorbed.size());
    for (std::size_t i = 0; i < one.absorbed.size(); ++i)
        EXPECT_EQ(one.absorbed[i].absorbed.channel, three.absorbed[i].absorbed.channel);
    EXPECT_EQ(one.cut_off.channel, three.cut_off.channel);
}

TEST(EnergyLedger, OfASceneWithoutLightIsEmpty) {
    SceneKit kit = room();
    kit.scene.lights.clear();
    const EnergyLedger ledger = energy_ledger(kit.commit(), 0);
    EXPECT_EQ(ledger.paths, 0U);
    EXPECT_EQ(ledger.imbalance(), 0);
    EXPECT_TRUE(ledger_warnings(ledger).empty());
}

/// Reflects evenly, `gain` times what arrives.
class GainBsdf final : public Bsdf {
public:
    explicit GainBsdf(float gain) : gain_(gain) {}
    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse; }
    [[nodiscard]] Rgb f(Vec3, Vec3) const noexcept override { return Rgb(gain_ * inv_pi); }
    [[nodiscard]] float pdf(Vec3, Vec3 wi, Lobe) const noexcept override { return std::abs(wi.z) * inv_pi; }
    [[nodiscard]] BsdfSample sample(Vec3, float, Vec2 u, Lobe) const noexcept override {
        const Vec3 wi = sample_cosine_hemisphere(u);
        return {wi, Rgb(gain_), wi.z * inv_pi, Lobe::diffuse};
    }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return {.diffuse = Rgb(1)}; }

private:
    float gain_;
};
class GainShader final : public Shader {
public:
    explicit GainShader(float gain) : gain_(gain) {}
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept override {
        return memory.make<GainBsdf>(gain_);
    }

private:
    float gain_;
};
std::shared_ptr<const Shader> make_generous(const ShaderInputs&) { return std::make_shared<GainShader>(1.02F); }
std::shared_ptr<const Shader> make_broken(const ShaderInputs&) {
    return std::make_shared<GainShader>(std::numeric_limits<float>::quiet_NaN());
}

EnergyLedger floor_of(const char* kind) {
    const std::unique_ptr<Registry> registry = make_registry();
    shaders::add_builtins(*registry);
    registry->add(ShaderKind{"generous", "", {}, make_generous});
    registry->add(ShaderKind{"broken", "", {}, make_broken});
    SceneKit kit = room();
    kit.root(kit.box({0.2, 0.2, 0}, {0.8, 0.8, 0.1}, kit.material("odd", kind, {})));
    return energy_ledger(CommittedScene(kit.scene, *registry, csg::compile, {.studio = false}), 0);
}

TEST(EnergyLedger, NamesAMaterialThatGivesOutMoreThanItGets) {
    const EnergyLedger ledger = floor_of("generous");
    EXPECT_LT(ledger.imbalance(), 1e-5);
    EXPECT_NEAR(of(ledger, "odd").absorbed.sum(), -0.02 * of(ledger, "odd").received.sum(),
                1e-4 * of(ledger, "odd").received.sum());
    const std::vector<std::string> warnings = ledger_warnings(ledger);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings[0], "material \"odd\" gives out 2 % more light than it gets");
    EXPECT_TRUE(ledger_warnings(floor_of("diffuse")).empty());
}

TEST(EnergyLedger, CountsPathsThatMeetAMaterialThatIsNoNumber) {
    const EnergyLedger ledger = floor_of("broken");
    EXPECT_GT(ledger.bad_paths, 0U);
    EXPECT_LT(ledger.imbalance(), 1e-5);
    EXPECT_EQ(ledger_warnings(ledger).size(), 1U);
}

TEST(EnergyLedger, AgreesWithTheIrradianceThatPathsMeasure) {
    SceneKit kit = room();
    const CommittedScene scene = kit.commit();
    const EnergyLedger ledger = energy_ledger(scene, 1, 1 << 18);
    const std::unique_ptr<LightingModule> path = path_lighting.make({}, 0);
    Progress silent;
    path->prepare(scene, nullptr, silent);
    struct Face {
        const char* material;
        Vec3d corner, u, v, n;
        Rgb reflectance;
    };
    const Rgb black;
    const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, o;
    const std::vector<Face> faces{{"floor", o, x, y, z, {0.5F, 0.5F, 0.3F}},
                                  {"ceiling", z, x, y, -z, {0.8F, 0.5F, 0.3F}},
                                  {"left", o, y, z, x, {0.2F, 0.5F, 0.3F}},
                                  {"right", x, y, z, -x, {0.9F, 0.5F, 0.3F}},
                                  {"front", o, x, z, y, {0.6F, 0.5F, 0.3F}},
                                  {"behind", y, x, z, -y, {0.4F, 0.5F, 0.3F}},
                                  {"lamp", {0.4, 0.35, 0.9}, x * 0.4, y * 0.3, z, black},
                                  {"lamp", {0.4, 0.35, 0.9}, x * 0.4, y * 0.3, -z, black}};
    constexpr int n = 12;  // places a side, one at random in each field
    std::vector<MaterialFlux> found(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        std::vector<ProbePoint> points;
        for (int i = 0; i < n * n; ++i) {
            Sampler sampler(7, Purpose::test, f, static_cast<std::uint32_t>(i));
            const Vec2 u = sampler.next2();
            points.push_back(
                {faces[f].corner + faces[f].u * ((i % n + double{u.x}) / n) + faces[f].v * ((i / n + double{u.y}) / n),
                 faces[f].n});
        }
        const double area = length(cross(faces[f].u, faces[f].v));
        for (const Reading& r : probe(scene, *path, points, {.noise = 0, .most_samples = 128}, silent)) {
            EXPECT_FALSE(r.buried);
            const Rgb taken = r.value * (Rgb(1) - faces[f].reflectance);
            found[f].absorbed += Flux{{double{taken.r}, double{taken.g}, double{taken.b}}} * (area / (n * n));
        }
    }
    double all = 0;
    for (std::size_t f = 0; f + 1 < faces.size(); ++f) {
        Flux sum = found[f].absorbed;
        if (f + 2 == faces.size()) sum += found[f + 1].absorbed;
        const MaterialFlux& booked = of(ledger, faces[f].material);
        // The probes have some 0.3 %, and Sobol is better than the ledger says.
        const double error = booked.error + 0.003 * sum.sum();
        EXPECT_LT(std::abs(booked.absorbed.sum() - sum.sum()), 3 * error) << faces[f].material;
        EXPECT_GT(std::abs(1.05 * booked.absorbed.sum() - sum.sum()), 3 * error) << faces[f].material;
        all += sum.sum();
    }
    EXPECT_NEAR(all, ledger.power.sum(), 0.01 * all);
}

}  // namespace
}  // namespace cardioid

#pragma once
#include <bit>
#include <memory>
#include <string>
#include <vector>

#include "csg/compile.hpp"
#include "rt_core/plugin/registry.hpp"
#include "rt_core/render/committed_scene.hpp"
#include "shaders/builtins.hpp"

namespace cardioid::test {

inline Params params_of(std::initializer_list<std::pair<const char*, std::vector<double>>> values) {
    Params params("test.csg:1:1");
    for (const auto& [name, numbers] : values)
        params.set(name, ParamValue{.numbers = numbers, .list = numbers.size() > 1});
    return params;
}

inline const Registry& builtins() {
    static const std::unique_ptr<Registry> registry = [] {
        auto made = make_registry();
        shaders::add_builtins(*made);
        return made;
    }();
    return *registry;
}

/// A scene put together by hand.
class SceneKit {
public:
    SceneKit() {
        scene.file = "test.csg";
        scene.six_digits = false;
        material("default", "diffuse", {{"reflectance", {0.5}}});
    }
    std::uint32_t material(const std::string& name, const std::string& kind,
                           std::initializer_list<std::pair<const char*, std::vector<double>>> values) {
        scene.materials.push_back({name, kind, params_of(values)});
        return static_cast<std::uint32_t>(scene.materials.size() - 1);
    }
    std::uint32_t leaf(LeafKind kind, const Affine& to_world, std::uint32_t material) {
        Leaf made;
        made.kind = kind;
        made.to_world = to_world;
        made.material = material;
        return scene.solids.add_leaf(made);
    }
    std::uint32_t box(Vec3d lo, Vec3d hi, std::uint32_t material) {
        Affine to_world = Affine::scaling(hi - lo);
        to_world.t = lo;
        return leaf(LeafKind::box, to_world, material);
    }
    std::uint32_t ball(Vec3d centre, double r, std::uint32_t material) {
        Affine to_world = Affine::scaling({r, r, r});
        to_world.t = centre;
        return leaf(LeafKind::sphere, to_world, material);
    }
    void root(std::uint32_t node) { scene.solids.roots.push_back(node); }
    void light(const std::string& kind, std::initializer_list<std::pair<const char*, std::vector<double>>> values,
               const Affine& to_world = {}) {
        scene.lights.push_back({kind, params_of(values), to_world});
    }
    [[nodiscard]] CommittedScene commit(const CommitOptions& options = {.studio = false}) const {
        return {scene, builtins(), csg::compile, options};
    }

    Scene scene;
};

/// What a ray from o along d meets first; the test fails where it meets nothing.
inline SurfacePoint seen(const World& world, Vec3d o, Vec3d d) {
    const Ray ray{o, normalize(d), Box3d::infinity, {}, {}};
    const Hit hit = world.intersect(ray);
    return hit.found() ? world.surface(ray, hit) : SurfacePoint{};
}

/// Reflects all light that comes to its outer side evenly: direct() times pi is then the irradiance.
class WhiteBsdf final : public Bsdf {
public:
    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override { return wo.z * wi.z > 0 ? Rgb(inv_pi) : Rgb{}; }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe) const noexcept override {
        return wo.z * wi.z > 0 ? std::abs(wi.z) * inv_pi : 0;
    }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float, Vec2 u, Lobe) const noexcept override {
        Vec3 wi = sample_cosine_hemisphere(u);
        const float pdf = wi.z * inv_pi;
        if (wo.z < 0) wi.z = -wi.z;
        return {wi, Rgb(pdf > 0 ? 1.0F : 0.0F), pdf, Lobe::diffuse};
    }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return {.diffuse = Rgb(1)}; }
};

/// Irradiance at p on the side of n: direct light alone, mean of n_samples.
inline double irradiance(const CommittedScene& scene, Vec3d p, Vec3 n, std::uint32_t n_samples) {
    SurfacePoint point;
    point.p = p;
    point.ng = n;
    point.frame = Frame(n);
    const WhiteBsdf white;
    double sum = 0;
    for (std::uint32_t i = 0; i < n_samples; ++i) {
        Sampler sampler(1, Purpose::test, std::bit_cast<std::uint64_t>(p.x + 3 * p.y + 7 * p.z), i);
        sum += scene.direct(point, white, n, sampler).g;
    }
    return sum / n_samples * std::numbers::pi;
}

}  // namespace cardioid::test

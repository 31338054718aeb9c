#include "bench/photon_emission.hpp"

#include <memory>
#include <omp.h>

#include "bench/models.hpp"

#include "csg/compile.hpp"
#include "photon/emission/shoot.hpp"
#include "rt_core/plugin/registry.hpp"
#include "rt_core/render/committed_scene.hpp"
#include "shaders/builtins.hpp"

namespace cardioid::bench {

namespace {

constexpr std::uint64_t count = 100'000;

const Registry& registry() {
    static const std::unique_ptr<Registry> made = [] {
        auto r = make_registry();
        shaders::add_builtins(*r);
        return r;
    }();
    return *made;
}

Params numbers(const char* name, std::vector<double> values) {
    Params params("bench");
    params.set(name, ParamValue{.numbers = values, .list = values.size() > 1});
    return params;
}

/// Grey walls and the lamp of the Cornell box, y up.
Scene empty_box() {
    Scene scene;
    scene.file = "bench";
    scene.six_digits = false;
    scene.materials.push_back({"grey", "diffuse", numbers("reflectance", {0.7, 0.7, 0.7})});
    Params lamp = numbers("size", {130, 105});
    lamp.set("power", 100.0);
    // The local z axis, which the lamp turns its back to, is the world's y.
    const Affine upright{{Vec3d{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, {278, 547.9, 279.5}};
    scene.lights.push_back({"area_light", lamp, upright});
    return scene;
}

Leaf leaf(LeafKind kind, const Affine& to_world) {
    Leaf made;
    made.kind = kind;
    made.to_world = to_world;
    made.material = 0;
    return made;
}

/// The box of the published data as a mesh without its front.
Scene triangles() {
    Scene scene = empty_box();
    Leaf mesh = leaf(LeafKind::mesh, {});
    mesh.data = scene.solids.add_mesh(cornell_box());
    scene.solids.roots.push_back(scene.solids.add_leaf(mesh));
    return scene;
}

Affine block(double size, double height, double turn, Vec3d at) {
    const double c = std::cos(turn), s = std::sin(turn);
    return {{Vec3d{c * size, 0, s * size}, {0, height, 0}, {-s * size, 0, c * size}}, at};
}

/// Nearly the same box, cut out of a larger one, with two blocks.
Scene solids() {
    Scene scene = empty_box();
    SolidTree& tree = scene.solids;
    const auto box = [&](Vec3d lo, Vec3d hi) {
        Affine to_world = Affine::scaling(hi - lo);
        to_world.t = lo;
        return tree.add_leaf(leaf(LeafKind::box, to_world));
    };
    tree.roots.push_back(
        tree.add_node(SolidOp::subtract, {box({-10, -10, 0}, {566, 559, 569}), box({0, 0, -10}, {556, 549, 559})}));
    tree.roots.push_back(tree.add_leaf(leaf(LeafKind::box, block(165, 165, 0.29, {82, 0, 114}))));
    tree.roots.push_back(tree.add_leaf(leaf(LeafKind::box, block(165, 330, -0.3, {300, 0, 250}))));
    return scene;
}

void add(const std::string& name, Scene (*make)(), int threads) {
    benchmark::RegisterBenchmark(name.c_str(), [make, threads](benchmark::State& state) {
        const CommittedScene scene(make(), registry(), csg::compile, {.studio = false});
        const int before = omp_get_max_threads();
        omp_set_num_threads(threads);
        Progress progress;
        std::uint64_t stored = 0, rays = 0;
        std::uint32_t seed = 0;
        for (auto _ : state) {
            const photon::Shot shot = photon::shoot(scene, {}, {.seed = ++seed, .count = count}, progress);
            stored += shot.photons.size();
            rays += shot.ledger.rays;
        }
        state.SetItemsProcessed(static_cast<std::int64_t>(stored));
        state.counters["rays"] = benchmark::Counter(static_cast<double>(rays), benchmark::Counter::kIsRate);
        omp_set_num_threads(before);
    })->MeasureProcessCPUTime();
}

}  // namespace

void register_photon_emission_benchmarks() {
    add("photons/cornell_box", triangles, 1);
    add("photons/cornell_csg", solids, 1);
    add("photons/cornell_box/2_threads", triangles, 2);
}

std::vector<Goal> photon_emission_goals() {
    // 4 M and 1 M a second where Embree alone traces 12 M rays after a bounce; threads may cost 5 % of CPU time.
    return {{"photons/cornell_box", "embree/box_32/incoherent", 4.0 / 12},
            {"photons/cornell_csg", "embree/box_32/incoherent", 1.0 / 12},
            {"photons/cornell_box/2_threads", "photons/cornell_box", 0.95}};
}

}  // namespace cardioid::bench

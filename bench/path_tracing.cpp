#include "bench/path_tracing.hpp"

#include <memory>
#include <omp.h>

#include "bench/cornell_box.hpp"

#include "csg/compile.hpp"
#include "rt_core/plugin/registry.hpp"
#include "rt_core/render/lighting/direct_lighting.hpp"
#include "rt_core/render/lighting/path_lighting.hpp"
#include "rt_core/render/renderer.hpp"
#include "shaders/builtins.hpp"

namespace cardioid::bench {
namespace {

/// 2 M paths a CPU second where Embree traces 12 M rays after a diffuse bounce.
constexpr double path_share = 2.0 / 12;

const Registry& builtins() {
    static const std::unique_ptr<Registry> registry = [] {
        auto made = make_registry();
        shaders::add_builtins(*made);
        return made;
    }();
    return *registry;
}

/// One picture of the scene, small, with as many samples as a quick one has.
class Picture {
public:
    Picture(const Scene& scene, const LightingKind& kind)
        : world_(scene, builtins(), csg::compile), lighting_(kind.make(Params("bench"), 0)) {
        omp_set_num_threads(1);  // CPU time is that of this thread
        settings_.width = settings_.height = 128;
        settings_.samples = 16;
        settings_.camera = scene.cameras[0];
        lighting_->prepare(world_, nullptr, progress_);
    }
    /// Its camera samples.
    std::uint64_t render() {
        ++settings_.seed;
        return cardioid::render(world_, *lighting_, settings_, progress_).statistics.camera_rays;
    }

private:
    CommittedScene world_;
    std::unique_ptr<LightingModule> lighting_;
    RenderSettings settings_;
    Progress progress_;
};

void add(const char* name, Scene (*scene)(), const LightingKind& kind) {
    benchmark::RegisterBenchmark(name, [scene, &kind](benchmark::State& state) {
        Picture picture(scene(), kind);
        std::uint64_t paths = 0;
        for (auto _ : state) paths += picture.render();
        state.SetItemsProcessed(static_cast<std::int64_t>(paths));
    });
}

}  // namespace

void register_path_benchmarks() {
    add("path/blocks", cornell_blocks, path_lighting);
    add("path/balls", cornell_balls, path_lighting);
    add("direct/blocks", cornell_blocks, direct_lighting);
}

std::vector<Goal> path_goals() { return {{"path/blocks", "embree/box_32/incoherent", path_share}}; }

}  // namespace cardioid::bench

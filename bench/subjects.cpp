#include "bench/subjects.hpp"

#include <array>

#include "csg/compile.hpp"

namespace cardioid::bench {
namespace {

constexpr std::uint32_t picture_width = 256;
constexpr std::uint32_t ray_count = picture_width * picture_width;
/// Four units in the last place: what our tracer lifts rays that leave a triangle.
constexpr double lift = 4 * 0x1p-23;

std::unique_ptr<Tracer> trace_mesh(const TriangleMesh& mesh) {
    Geometry geometry;
    geometry.surfaces.push_back({std::make_shared<const TriangleMesh>(mesh), {}, 0});
    return std::make_unique<Tracer>(std::move(geometry), std::vector<LampShape>{});
}

std::unique_ptr<Tracer> trace_solids(const SolidTree& solids) {
    Scene scene;
    scene.solids = solids;
    return std::make_unique<Tracer>(csg::compile(scene, {}), std::vector<LampShape>{});
}

void count_rays(benchmark::State& state, std::size_t rays) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays));
}

/// Registers a benchmark that calls trace(subject, ray) for each ray that rays(subject) names.
template <class Subject, class RaysOf, class Trace>
void add(const std::string& name, Named<Subject>& subject, RaysOf rays_of, Trace trace) {
    benchmark::RegisterBenchmark(name.c_str(), [&subject, rays_of, trace](benchmark::State& state) {
        const Subject& s = subject.get();
        const auto& rays = s.*rays_of;
        for (auto _ : state)
            for (const Ray& ray : rays) benchmark::DoNotOptimize(trace(*s.tracer, ray));
        count_rays(state, rays.size());
    });
}

Hit intersect(const Tracer& tracer, const Ray& ray) { return tracer.intersect(ray); }
bool occluded(const Tracer& tracer, const Ray& ray) { return tracer.occluded(ray); }

/// The same for Embree alone.
template <class Trace>
void add_raw(const std::string& name, Named<MeshSubject>& subject, RawEmbree MeshSubject::*embree,
             std::vector<RTCRay> MeshSubject::*rays, Trace trace) {
    benchmark::RegisterBenchmark(name.c_str(), [&subject, embree, rays, trace](benchmark::State& state) {
        const MeshSubject& s = subject.get();
        for (auto _ : state) benchmark::DoNotOptimize((s.*embree.*trace)(s.*rays));
        count_rays(state, (s.*rays).size());
    });
}

/// Million rays per CPU second of the design's prototype: primary, random, started inside.
struct PrototypeFigures {
    std::string model;
    std::array<double, 3> rate;
};
const std::array<PrototypeFigures, 5> prototype{{{"parts_200", {8.0, 3.7, 3.4}},
                                                 {"swiss_cheese_1000", {6.3, 1.5, 1.8}},
                                                 {"chain_5000", {3.0, 0.92, 0.54}},
                                                 {"ball_union_10000", {6.9, 3.1, 3.5}},
                                                 {"random_tree_5000", {5.3, 1.2, 2.9}}}};
/// Of Embree alone on the Cornell box, on the machine of the prototype: primary, after a diffuse bounce.
constexpr double prototype_primary = 17, prototype_bounce = 12;

/// Triangles are to reach this share of Embree alone.
constexpr double triangle_share = 0.9;
constexpr double most_bytes_a_leaf = 200, most_triangle_memory = 1.2;

}  // namespace

MeshSubject::MeshSubject(const TriangleMesh& mesh, const View& view)
    : tracer(trace_mesh(mesh)),
      robust(mesh, RawEmbree::Flags::robust),
      plain(mesh, RawEmbree::Flags::plain),
      primary(primary_rays(view, picture_width)),
      incoherent(mesh.closed ? random_rays(tracer->bounds(), ray_count) : bounced_rays(*tracer, primary, ray_count)),
      raw_primary(raw_rays(primary, lift)),
      raw_incoherent(raw_rays(incoherent, lift)) {}

SolidSubject::SolidSubject(const Model& model)
    : tracer(trace_solids(model.solids)),
      primary(primary_rays(model.view, picture_width)),
      random(random_rays(tracer->bounds(), ray_count)),
      inside(inside_rays(tracer->bounds(), ray_count)) {}

Subjects list_subjects() {
    const auto ball = [](std::uint32_t rings) {
        return [rings] { return std::make_unique<MeshSubject>(bumpy_ball(rings), ball_view); };
    };
    Subjects s;
    s.meshes.push_back({"box_32", [] { return std::make_unique<MeshSubject>(cornell_box(), cornell_view); }});
    s.meshes.push_back({"ball_17k", ball(66)});
    s.meshes.push_back({"ball_200k", ball(225)});
    for (Model& model : all_models()) {
        const std::string name = model.name;
        s.solids.push_back({name, [m = std::move(model)] { return std::make_unique<SolidSubject>(m); }});
    }
    for (const std::uint32_t count : {100U, 1000U, 10000U, 100000U})
        s.growth.push_back({"growth/" + std::to_string(count),
                            [count] { return std::make_unique<SolidSubject>(swiss_cheese(count)); }});
    return s;
}

void register_benchmarks(Subjects& subjects) {
    using Mesh = MeshSubject;
    for (Named<Mesh>& m : subjects.meshes) {
        const std::string raw = "embree/" + m.name, robust = "embree_robust/" + m.name;
        add_raw(raw + "/primary", m, &Mesh::plain, &Mesh::raw_primary, &RawEmbree::trace);
        add_raw(raw + "/incoherent", m, &Mesh::plain, &Mesh::raw_incoherent, &RawEmbree::trace);
        add_raw(robust + "/primary", m, &Mesh::robust, &Mesh::raw_primary, &RawEmbree::trace);
        add_raw(robust + "/incoherent", m, &Mesh::robust, &Mesh::raw_incoherent, &RawEmbree::trace);
        add_raw(robust + "/occluded", m, &Mesh::robust, &Mesh::raw_incoherent, &RawEmbree::trace_occlusion);
        add(m.name + "/primary", m, &Mesh::primary, intersect);
        add(m.name + "/incoherent", m, &Mesh::incoherent, intersect);
        add(m.name + "/occluded", m, &Mesh::incoherent, occluded);
    }
    for (auto* group : {&subjects.solids, &subjects.growth})
        for (Named<SolidSubject>& s : *group) {
            add(s.name + "/primary", s, &SolidSubject::primary, intersect);
            add(s.name + "/random", s, &SolidSubject::random, intersect);
            add(s.name + "/inside", s, &SolidSubject::inside, intersect);
        }
}

std::vector<Goal> speed_goals(const Subjects& subjects) {
    std::vector<Goal> goals;
    for (const auto& m : subjects.meshes)
        for (const char* rays : {"/primary", "/incoherent", "/occluded"})
            goals.push_back({m.name + rays, "embree_robust/" + m.name + rays, triangle_share});
    const std::string box = "embree/" + subjects.meshes.front().name;
    for (const PrototypeFigures& p : prototype) {
        goals.push_back({p.model + "/primary", box + "/primary", p.rate[0] / prototype_primary});
        goals.push_back({p.model + "/random", box + "/incoherent", p.rate[1] / prototype_bounce});
        goals.push_back({p.model + "/inside", box + "/incoherent", p.rate[2] / prototype_bounce});
    }
    const auto grown = [&](std::size_t i, const char* rays) { return subjects.growth[i].name + rays; };
    // Ten times the leaves may cost twice the time: what a hierarchy promises, with room for the caches.
    for (std::size_t i = 1; i < subjects.growth.size(); ++i)
        for (const char* rays : {"/primary", "/random"}) goals.push_back({grown(i, rays), grown(i - 1, rays), 0.5});
    return goals;
}

std::vector<Bound> memory_bounds(const Subjects& subjects) {
    std::vector<Bound> bounds;
    for (const auto& m : subjects.meshes) {
        if (!m.made || m.made->tracer->memory().triangle_count < 1000) continue;  // a small mesh is all overhead
        const TracerMemory memory = m.made->tracer->memory();
        bounds.push_back(
            {m.name + ": bytes over those of Embree alone",
             static_cast<double>(memory.embree + memory.triangles) / static_cast<double>(m.made->robust.memory_bytes()),
             most_triangle_memory});
    }
    for (const auto* group : {&subjects.solids, &subjects.growth})
        for (const auto& s : *group) {
            if (!s.made) continue;
            const TracerMemory memory = s.made->tracer->memory();
            bounds.push_back({s.name + ": bytes a leaf",
                              static_cast<double>(memory.regions) / static_cast<double>(memory.leaves),
                              most_bytes_a_leaf});
        }
    return bounds;
}

}  // namespace cardioid::bench

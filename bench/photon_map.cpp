#include "bench/photon_map.hpp"

#include <functional>
#include <map>
#include <memory>
#include <omp.h>

#include "bench/photon_clouds.hpp"
#include "bench/photon_heap.hpp"
#include "bench/photon_octree.hpp"
#if defined(CARDIOID_NANOFLANN)
#include "bench/nano_map.hpp"
#endif

#include "photon/map/photon_map.hpp"

namespace cardioid::bench {
namespace {

using photon::Neighbours;
using photon::Photon;
using photon::PointQuery;

/// Our map as the benchmarks call every structure: with the quickest inner loops, or the ones that are the n-th
/// slowest.
template <std::size_t nth_slowest = 0>
class OurMap {
public:
    explicit OurMap(const PhotonCloud& cloud) : tree_(cloud.photons) {
        const auto kernels = photon::usable_kernels();
        if (nth_slowest > 0 && nth_slowest <= kernels.size()) tree_.use(kernels[kernels.size() - nth_slowest]);
    }
    std::uint32_t nearest(Vec3 p, std::uint32_t k) {
        tree_.nearest(PointQuery{.p = p}, k, found_);
        return found_.size;
    }
    /// With every test that a lookup of the photon map has.
    std::uint32_t lookup(const Place& at, std::uint32_t k) {
        tree_.nearest({.p = at.p, .n = at.n, .least_cos = 0.5F, .steepness = 0.25F}, k, found_);
        return found_.size;
    }
    std::uint32_t one(Vec3 p) const { return tree_.nearest(PointQuery{.p = p}).index; }
    std::uint32_t within(Vec3 p, float radius) const {
        std::uint32_t count = 0;
        tree_.visit_within({.p = p, .max_radius = radius}, [&](std::uint32_t, float) { ++count; });
        return count;
    }
    [[nodiscard]] std::size_t memory_bytes() const { return tree_.memory_bytes(); }

private:
    photon::PointTree<Photon> tree_;
    Neighbours found_;
};

/// Whole lookups: irradiance by each rule.
class Lookups {
public:
    explicit Lookups(const PhotonCloud& cloud) : map_(cloud.photons, {}, 1) { map_.spread({.k = 150}); }
    float look(const Place& at, const photon::LookupRule& rule) const {
        SurfacePoint point;
        point.p = Vec3d(at.p);
        point.ng = at.n;
        return map_.irradiance(point, at.n, rule).E.g;
    }

private:
    photon::PhotonMap map_;
};

/// The left-balanced heap, and the octree.
template <class Tree>
class PlainMap {
public:
    explicit PlainMap(const PhotonCloud& cloud) : tree_(cloud.photons) {}
    std::uint32_t nearest(Vec3 p, std::uint32_t k) { return tree_.nearest(p, k, HUGE_VALF, d2_); }
    std::uint32_t one(Vec3 p) { return nearest(p, 1); }

private:
    Tree tree_;
    float d2_[Neighbours::max_k];
};
using HeapMap = PlainMap<PhotonHeap>;
using OctreeMap = PlainMap<PhotonOctree>;

/// A cloud and the structures over it, made when first asked for.
struct Subject {
    std::function<PhotonCloud()> make{};
    float radius = 0;  ///< of about 12.5 photons
    std::unique_ptr<PhotonCloud> cloud_{};
    std::unique_ptr<OurMap<>> ours_{};
    std::unique_ptr<OurMap<1>> plain_{};
    std::unique_ptr<OurMap<2>> second_{};
    std::unique_ptr<Lookups> lookups_{};
    std::unique_ptr<HeapMap> heap_{};
    std::unique_ptr<OctreeMap> octree_{};
#if defined(CARDIOID_NANOFLANN)
    std::unique_ptr<NanoMap> nano_{};
#endif

    const PhotonCloud& cloud() {
        if (!cloud_) cloud_ = std::make_unique<PhotonCloud>(make());
        return *cloud_;
    }
    template <class Map>
    Map& get(std::unique_ptr<Map>& map) {
        if (!map) map = std::make_unique<Map>(cloud());
        return *map;
    }
};

/// Walls of 10^4 to 10^7 photons, and a caustic.
Subject& walls(std::size_t n) {
    static std::map<std::size_t, Subject> subjects;
    Subject& s = subjects[n];
    s.make = [n] { return wall_cloud(n); };
    s.radius = std::sqrt(12.5F * 6 / (pi * static_cast<float>(n)));
    return s;
}
constexpr std::size_t million = 1'000'000;
Subject& caustic() {
    static Subject s{[] { return caustic_cloud(million); }};
    return s;
}

void count_items(benchmark::State& state, std::size_t items) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items));
}

template <class Map>
void add_build(const std::string& name, Subject& subject) {
    benchmark::RegisterBenchmark((name + "/build").c_str(), [&subject](benchmark::State& state) {
        const PhotonCloud& cloud = subject.cloud();
        const int threads = omp_get_max_threads();
        omp_set_num_threads(1);  // CPU time is the first thread's
        for (auto _ : state) benchmark::DoNotOptimize(Map(cloud));
        omp_set_num_threads(threads);
        count_items(state, cloud.photons.size());
    })->Unit(benchmark::kMillisecond);
}

/// Registers a benchmark that calls look(map, place) for each place, in both orders.
template <class Map, class Look>
void add_queries(const std::string& name, Subject& subject, std::unique_ptr<Map> Subject::*map, Look look) {
    for (const bool in_order : {false, true})
        benchmark::RegisterBenchmark((name + (in_order ? "/morton" : "/random")).c_str(),
                                     [&subject, map, look, in_order](benchmark::State& state) {
                                         Map& m = subject.get(subject.*map);
                                         const PhotonCloud& cloud = subject.cloud();
                                         const std::vector<Place>& places = in_order ? cloud.morton : cloud.random;
                                         for (auto _ : state)
                                             for (const Place& at : places) benchmark::DoNotOptimize(look(m, at));
                                         count_items(state, places.size());
                                     });
}

constexpr auto fifty = [](auto& map, const Place& at) { return map.nearest(at.p, 50); };
constexpr auto one = [](auto& map, const Place& at) { return map.one(at.p); };

void register_subject(const std::string& name, Subject& s) {
    add_build<OurMap<>>("photon_map/" + name, s);
    add_queries("photon_map/" + name + "/k50", s, &Subject::ours_, fifty);
    add_queries("photon_map/" + name + "/k1", s, &Subject::ours_, one);
#if defined(CARDIOID_NANOFLANN)
    add_build<NanoMap>("nanoflann/" + name, s);
    add_queries("nanoflann/" + name + "/k50", s, &Subject::nano_, fifty);
    add_queries("nanoflann/" + name + "/k1", s, &Subject::nano_, one);
#endif
    add_build<HeapMap>("photon_heap/" + name, s);
    add_queries("photon_heap/" + name + "/k50", s, &Subject::heap_, fifty);
    add_queries("photon_heap/" + name + "/k1", s, &Subject::heap_, one);
    add_build<OctreeMap>("photon_octree/" + name, s);
    add_queries("photon_octree/" + name + "/k50", s, &Subject::octree_, fifty);
    add_queries("photon_octree/" + name + "/k1", s, &Subject::octree_, one);
}

const std::size_t growth[] = {10'000, 100'000, 10'000'000};
std::string growth_name(std::size_t n) { return "photon_map/growth/" + std::to_string(n); }

}  // namespace

void register_photon_map_benchmarks() {
    Subject& s = walls(million);
    register_subject("walls", s);
    register_subject("caustic", caustic());
    add_queries("photon_map/walls/lookup50", s, &Subject::ours_,
                [](auto& map, const Place& at) { return map.lookup(at, 50); });
    const auto look = [](const photon::LookupRule& rule) {
        return [rule](const Lookups& map, const Place& at) { return map.look(at, rule); };
    };
    using photon::EdgeRule, photon::Kernel;
    add_queries("photon_map/walls/irradiance50", s, &Subject::lookups_, look({.edge = EdgeRule::none}));
    add_queries("photon_map/walls/irradiance50_hull", s, &Subject::lookups_, look({.edge = EdgeRule::hull}));
    add_queries("photon_map/walls/irradiance150_spread", s, &Subject::lookups_,
                look({.k = 150, .spread = true, .kernel = Kernel::cone, .edge = EdgeRule::none}));
    add_queries("photon_map/walls/k50/plain", s, &Subject::plain_, fifty);
    add_queries("photon_map/walls/k50/second", s, &Subject::second_, fifty);
    const float radius = s.radius;
    const auto within = [radius](auto& map, const Place& at) { return map.within(at.p, radius); };
    add_queries("photon_map/walls/radius", s, &Subject::ours_, within);
#if defined(CARDIOID_NANOFLANN)
    add_queries("nanoflann/walls/radius", s, &Subject::nano_, within);
#endif
    for (const std::size_t n : growth) {
        add_build<OurMap<>>(growth_name(n), walls(n));
        add_queries(growth_name(n) + "/k50", walls(n), &Subject::ours_, fifty);
    }
}

std::vector<Goal> photon_map_goals() {
    // Against nanoflann, and the heap of the books; then growth from 10^5 to 10^7, which may cost twice as much.
    std::vector<Goal> goals{{"photon_map/walls/build", "nanoflann/walls/build", 2}};
    for (const char* order : {"/random", "/morton"})
        for (const char* cloud : {"walls", "caustic"}) {
            const std::string k50 = std::string("/") + cloud + "/k50" + order;
            goals.push_back({"photon_map" + k50, "nanoflann" + k50, 3});
            goals.push_back({"photon_map" + k50, "photon_heap" + k50, 3});
        }
    for (const char* order : {"/k50/random", "/k50/morton"})
        goals.push_back({growth_name(10'000'000) + order, growth_name(100'000) + order, 0.5});
    return goals;
}

std::vector<Bound> photon_map_bounds() {
    std::vector<Bound> bounds;
    const auto add = [&](const std::string& name, const Subject& s) {
        if (!s.ours_) return;
        bounds.push_back({name + ": bytes a photon",
                          static_cast<double>(s.ours_->memory_bytes()) / static_cast<double>(s.cloud_->photons.size()),
                          33.1});
    };
    add("photon map, walls", walls(million));
    add("photon map, caustic", caustic());
    for (const std::size_t n : growth) add("photon map, " + std::to_string(n), walls(n));
    return bounds;
}

}  // namespace cardioid::bench

/// The same bits for any number of threads, and again (A14).
#include <gtest/gtest.h>

#include "rt_core/render/probe.hpp"
#include "rt_core/render/renderer.hpp"
#include "tests/accuracy/lit_scene.hpp"
#include "tests/accuracy/threads.hpp"

namespace cardioid::test {
namespace {

constexpr const char* scenes[] = {"rooms/nested_furnace.csg", "rooms/plates.csg", "caustics/ring_mirror.csg"};

std::vector<float> numbers(const std::vector<Reading>& readings) {
    std::vector<float> all;
    for (const Reading& r : readings)
        for (const Rgb c : {r.value, r.standard_error}) all.insert(all.end(), {c.r, c.g, c.b});
    return all;
}

/// Irradiances in free space, by as many threads.
std::vector<float> probed(const std::string& file, int threads) {
    const Threads guard(threads);
    const CommittedScene scene = commit(sample_scene("accuracy/" + file));
    const auto lighting = prepared_lighting("path", scene, 3);
    std::vector<ProbePoint> points;
    for (int i = 0; i < 8; ++i) points.push_back({{0.3 - 0.02 * i, 0.2, 0.15 + 0.01 * i}, {0.1 * i - 1, 0.5, 1}});
    Progress silent;
    return numbers(probe(scene, *lighting, points, {.noise = 0.05, .most_samples = 128, .seed = 3}, silent));
}

std::vector<float> drawn(const std::string& file, int threads) {
    const Threads guard(threads);
    const Scene description = sample_scene("accuracy/" + file);
    const CommittedScene scene = commit(description);
    const auto lighting = prepared_lighting("path", scene, 3);
    RenderSettings settings{.width = 24, .height = 18, .samples = 3, .seed = 3, .camera = description.cameras.at(0)};
    Progress silent;
    return render(scene, *lighting, settings, silent).film.layers.at(0).pixels;
}

TEST(Determinism, OfProbesForAnyNumberOfThreads) {
    for (const char* file : scenes) {
        const std::vector<float> one = probed(file, 1);
        for (const int threads : {1, 2, 7}) EXPECT_TRUE(one == probed(file, threads)) << file << " " << threads;
    }
    EXPECT_FALSE(probed("rooms/plates.csg", 1) == probed("caustics/ring_mirror.csg", 1));
}

TEST(Determinism, OfPicturesForAnyNumberOfThreads) {
    for (const char* file : scenes) {
        const std::vector<float> one = drawn(file, 1);
        for (const int threads : {1, 2, 7}) EXPECT_TRUE(one == drawn(file, threads)) << file << " " << threads;
    }
    EXPECT_FALSE(drawn("rooms/plates.csg", 1) == drawn("caustics/ring_mirror.csg", 1));
}

}  // namespace
}  // namespace cardioid::test

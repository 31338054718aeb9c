/// The benchmarks: cardioid_bench [--goals FILE.json] [Google Benchmark's options].
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iterator>

#include "bench/path_tracing.hpp"
#include "bench/photon_emission.hpp"
#include "bench/photon_map.hpp"
#include "bench/subjects.hpp"

namespace {

using namespace cardioid::bench;

/// Takes `--goals FILE` out of the words; null where it is not there.
const char* take_goals_file(std::vector<char*>& words) {
    for (std::size_t i = 1; i + 1 < words.size(); ++i) {
        if (std::strcmp(words[i], "--goals") != 0) continue;
        const char* file = words[i + 1];
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(i), words.begin() + static_cast<std::ptrdiff_t>(i + 2));
        return file;
    }
    return nullptr;
}

int run(int argc, char** argv) {
    // Several short repetitions in random order, so that a busy machine is as unkind to the yardsticks as to us.
    static char repetitions[] = "--benchmark_repetitions=5", interleaved[] = "--benchmark_enable_random_interleaving",
                seconds[] = "--benchmark_min_time=0.2", medians[] = "--benchmark_report_aggregates_only";
    std::vector<char*> words{argv[0], repetitions, interleaved, seconds, medians};
    words.insert(words.end(), argv + 1, argv + argc);
    const char* goals_file = take_goals_file(words);
    int count = static_cast<int>(words.size());
    benchmark::Initialize(&count, words.data());
    if (benchmark::ReportUnrecognizedArguments(count, words.data())) return 2;
    Subjects subjects = list_subjects();
    register_benchmarks(subjects);
    register_photon_map_benchmarks();
    register_photon_emission_benchmarks();
    register_path_benchmarks();
    GoalReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    auto goals = speed_goals(subjects);
    std::ranges::copy(photon_map_goals(), std::back_inserter(goals));
    std::ranges::copy(photon_emission_goals(), std::back_inserter(goals));
    std::ranges::copy(path_goals(), std::back_inserter(goals));
    auto bounds = memory_bounds(subjects);
    std::ranges::copy(photon_map_bounds(), std::back_inserter(bounds));
    reporter.print(goals, bounds);
    if (goals_file) reporter.write(goals_file, goals, bounds);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "cardioid_bench: %s\n", e.what());
        return 1;
    }
}

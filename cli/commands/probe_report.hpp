#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "cli/options/probe_options.hpp"
#include "rt_core/api/lighting.hpp"
#include "rt_core/render/committed_scene.hpp"

namespace cardioid::cli {

/// What all readings together tell.
struct ProbeTotals {
    std::uint64_t points = 0, samples = 0, bad_samples = 0;
    std::uint64_t buried = 0;  ///< points inside opaque solids
    std::uint64_t noisy = 0;   ///< points that did not reach the noise asked for
    double seconds = 0;        ///< wall clock, of the probe phase
    bool interrupted = false;
    void add(const Reading& reading);
};

/// Line "R G B seR seG seB" with its end.
std::string reading_line(const Reading& reading);

/// JSON of one point.
std::string reading_json(const ProbePoint& point, const Reading& reading);

/// What stands around the points in the JSON file.
std::string json_head(const ProbeOptions& options, const LightingKind& lighting, const CommittedScene& scene);
std::string json_tail(const ProbeTotals& totals, const LightingModule& module);

/// What a user must know of readings that are not what they seem.
std::vector<std::string> probe_warnings(const ProbeTotals& totals);
/// Lines for -v.
std::vector<std::string> probe_lines(const ProbeTotals& totals, const LightingModule& module);

}  // namespace cardioid::cli

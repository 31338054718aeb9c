#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/io/scene_input.hpp"
#include "cli/options/run_options.hpp"
#include "rt_core/render/probe.hpp"

namespace cardioid::cli {

/// All that `cardioid probe` was told.
struct ProbeOptions : RunOptions {
    SceneOptions scene;
    std::string points;  ///< a file, "-" is standard input
    Quantity what = Quantity::irradiance;
    double noise = 0;           ///< 0: not said
    std::uint32_t samples = 0;  ///< 0: not said
    bool ground = false;
    std::string output;  ///< of the lines; "-" is standard output, "" none
    std::string json;    ///< "" none

    /// What of these the library is told.
    [[nodiscard]] ProbeSettings settings_for_probe() const;
};

/// Reads the command line of `probe`. Nothing: help was printed. Throws Error(usage).
std::optional<ProbeOptions> parse_probe_options(const std::vector<std::string>& words);

}  // namespace cardioid::cli

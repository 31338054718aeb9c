#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/options/render_options.hpp"
#include "rt_core/image/image_file.hpp"
#include "rt_core/render/measure/energy_ledger.hpp"
#include "rt_core/render/renderer.hpp"

namespace cardioid::cli {

/// What there is to tell about a finished render.
struct RenderReport {
    const RenderOptions& options;
    const Scene& scene;
    const CommittedScene& committed;
    const LightingKind& lighting;
    const LightingModule& module;
    const RenderSettings& settings;
    const RenderStatistics& statistics;
    std::string command;                                     ///< recorded_command()
    std::vector<std::pair<std::string, double>> phases_s{};  ///< wall clock seconds, in order
    std::optional<EnergyLedger> energy{};                    ///< where it is told
};

/// Version, command line, seed, scene hash, samples. The same for any number of threads.
Metadata picture_metadata(const RenderReport& report);

/// The text of --stats: JSON.
std::string statistics_json(const RenderReport& report);

/// Lines for -v.
std::vector<std::string> statistics_lines(const RenderReport& report);

}  // namespace cardioid::cli

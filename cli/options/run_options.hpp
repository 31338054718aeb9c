#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/arguments.hpp"
#include "cli/terminal/console.hpp"

namespace cardioid::cli {

/// What every command that traces light was told; what is empty was not said.
struct RunOptions {
    std::string lighting;
    std::optional<double> photon_error;  ///< what --quality or --noise asks of photon.error
    std::string photons;                 ///< "true" or a count
    bool no_photons = false;
    std::vector<std::string> settings;  ///< "module.option=value"
    std::string save_map, load_map;

    std::uint32_t seed = 0;
    int threads = 0;  ///< 0: as OpenMP has it

    std::string progress = "auto";
    bool quiet = false, verbose = false;

    [[nodiscard]] Loudness loudness() const {
        return quiet ? Loudness::quiet : verbose ? Loudness::verbose : Loudness::normal;
    }
};

/// --lighting, --photons, --set, maps; `fallback` is the lighting where none is named, for the help.
void add_lighting_options(Arguments& arguments, RunOptions& options, const std::string& fallback);
/// --seed and -j; `result` is what they do not change ("picture").
void add_seed_options(Arguments& arguments, RunOptions& options, const std::string& result);
/// --progress, -q, -v.
void add_message_options(Arguments& arguments, RunOptions& options);

/// Throws Error(usage) where both of two options are given that exclude each other.
void exclude(bool a, bool b, std::string_view names);
/// Throws Error(usage) where these options contradict each other.
void check_run_options(const RunOptions& options);

}  // namespace cardioid::cli

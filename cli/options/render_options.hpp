#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/io/scene_input.hpp"
#include "cli/options/run_options.hpp"

namespace cardioid::cli {

/// All that `cardioid render` was told; what is empty was not said.
struct RenderOptions : RunOptions {
    SceneOptions scene;
    std::string output;
    bool half = false;
    std::optional<double> exposure;
    std::vector<std::string> layers;
    std::string view;

    std::optional<std::array<int, 2>> size;
    std::optional<std::array<int, 4>> crop;
    std::optional<int> samples;
    std::optional<int> quality_samples;  ///< what --quality stands for
    double time_s = 0, noise = 0;
    bool gaussian_filter = false;

    std::string camera;
    std::optional<double> azimuth_deg, elevation_deg, fov_deg;
    std::optional<Vec3d> eye, target;

    bool ground = false;
    std::string stats;
};

/// Reads the command line of `render`. Nothing: help was printed. Throws Error(usage).
std::optional<RenderOptions> parse_render_options(const std::vector<std::string>& words);

/// The words that make the picture what it is, for its metadata: without those for output, threads and messages, so
/// that the same picture is the same file.
std::string recorded_command(const std::vector<std::string>& words);

}  // namespace cardioid::cli

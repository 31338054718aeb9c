#pragma once
#include <chrono>
#include <cstdint>
#include <vector>

#include "rt_core/render/film_sums.hpp"
#include "rt_core/render/tiles.hpp"

namespace cardioid {

/// How many samples the next pass takes, and whether time is up. With neither time nor noise given passes double until
/// they have 16 samples, so that an interrupted picture is even.
class PassPlan {
public:
    explicit PassPlan(const RenderSettings& settings);
    /// Samples of the pass that begins after `done`; 0 when none is left.
    [[nodiscard]] std::uint32_t next(std::uint32_t done) const noexcept;
    [[nodiscard]] bool time_is_up() const noexcept;
    /// Since the plan was made.
    [[nodiscard]] double seconds() const noexcept;
    /// Share of the work in [0, 1] once `done` samples a pixel are there.
    [[nodiscard]] double share(double done) const noexcept;

private:
    std::uint32_t most_samples_;
    double time_s_;
    bool noise_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Measures how noisy each tile is: the root mean square over its pixels of the standard error of their luminance,
/// estimated from the means of passes of equal size, over the tile's mean luminance (at least 1/100 of the picture's,
/// so that black corners end).
class NoiseMeter {
public:
    /// limit: the relative standard error to reach.
    NoiseMeter(double limit, std::size_t pixels) : limit_(limit), sums_(pixels), squares_(pixels) {}
    /// A pass of `samples` has just ended at the pixel, whose samples now sum up to `luminance_sum`.
    void add_pass(std::size_t pixel, float luminance_sum, std::uint32_t samples) noexcept;
    /// Whether a tile of these pixels needs no more after so many passes of `samples` each; `mean` is the luminance of
    /// the whole picture.
    [[nodiscard]] bool quiet(const std::vector<std::size_t>& pixels, std::uint32_t passes, std::uint32_t samples,
                             double mean) const noexcept;

private:
    double limit_;
    std::vector<float> sums_;     ///< of all samples up to the last pass
    std::vector<float> squares_;  ///< sum of the squares of the passes' means
};

}  // namespace cardioid

#pragma once
#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

#include "rt_core/render/film_sums.hpp"
#include "rt_core/render/tiles.hpp"

namespace cardioid {

/// How many samples the next pass takes, and whether time is up. Passes double until they have 16 samples, so that an
/// interrupted picture is even; where noise ends a render they grow by an eighth and are even in number.
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
/// relative to that luminance (and a tenth of the picture's, so that black corners end). Samples of one well-spread
/// sequence are not independent, and errors estimated as if they were come out too large; so a pixel takes half of its
/// samples from each of two sequences, and the difference of their means tells the error without bias.
class NoiseMeter {
public:
    /// limit: the relative standard error to reach.
    NoiseMeter(double limit, std::size_t pixels) : limit_(limit), first_(pixels) {}
    /// A sample of the first sequence has been added to the pixel.
    void add(std::size_t pixel, float luminance) noexcept { first_[pixel] += luminance; }
    /// A pixel of a tile and the sum of the luminance of all its samples.
    struct Sum {
        std::size_t pixel;
        float luminance;
    };
    /// Whether a tile needs no more after so many samples a pixel; `mean` is the luminance of the whole picture.
    [[nodiscard]] bool quiet(std::span<const Sum> tile, std::uint32_t samples, double mean) const noexcept;

private:
    double limit_;
    std::vector<float> first_;  ///< luminance of the samples of the first sequence
};

}  // namespace cardioid

#include "rt_core/render/stop_rule.hpp"

#include <algorithm>
#include <cmath>

namespace cardioid {

namespace {

constexpr std::uint32_t largest_pass = 16;
/// The first pass where noise ends a render, and by what share of what is done the next ones grow it.
constexpr std::uint32_t first_noise_pass = 8, noise_growth = 8;
/// A tile of few pixels says little about its noise after few samples; together it must have so many.
constexpr std::size_t fewest_samples_of_tile = 2048;
/// Samples a pixel where only time or noise ends a render.
constexpr std::uint32_t most_samples = 1U << 20;
constexpr double dark_share = 0.1;

}  // namespace

PassPlan::PassPlan(const RenderSettings& settings)
    : most_samples_(settings.samples > 0 ? static_cast<std::uint32_t>(settings.samples) : most_samples),
      time_s_(settings.time_s),
      noise_(settings.noise > 0) {
    if (noise_) most_samples_ += most_samples_ % 2;
}

std::uint32_t PassPlan::next(std::uint32_t done) const noexcept {
    const std::uint32_t grown = std::max(done / noise_growth, 1U) + 1;
    const std::uint32_t size =
        noise_ ? (done == 0 ? first_noise_pass : grown - grown % 2) : std::clamp(done, 1U, largest_pass);
    return std::min(size, most_samples_ - std::min(done, most_samples_));
}

bool PassPlan::time_is_up() const noexcept { return time_s_ > 0 && seconds() >= time_s_; }

double PassPlan::seconds() const noexcept {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

double PassPlan::share(double done) const noexcept {
    const double samples = done / most_samples_;
    return std::min(1.0, time_s_ > 0 ? std::max(samples, seconds() / time_s_) : samples);
}

bool NoiseMeter::quiet(std::span<const Sum> tile, std::uint32_t samples, double mean) const noexcept {
    if (tile.size() * samples < fewest_samples_of_tile) return false;
    const double dark = dark_share * mean;
    double squares = 0;
    for (const Sum& sum : tile) {
        const double luminance = static_cast<double>(sum.luminance) / samples;
        const double error =
            (2 * static_cast<double>(first_[sum.pixel]) - static_cast<double>(sum.luminance)) / samples;
        const double level = luminance * luminance + dark * dark;
        if (level > 0) squares += error * error / level;
    }
    return std::sqrt(squares / static_cast<double>(tile.size())) <= limit_;
}

}  // namespace cardioid

#include "rt_core/render/stop_rule.hpp"

#include <algorithm>
#include <cmath>

namespace cardioid {

namespace {

constexpr std::uint32_t largest_pass = 16;
/// Equal passes for the noise estimate; with fewer than so many of them it means nothing.
constexpr std::uint32_t noise_pass = 8, fewest_noise_passes = 4;
/// Samples a pixel where only time or noise ends a render.
constexpr std::uint32_t most_samples = 1U << 20;
constexpr double dark_share = 0.01;

}  // namespace

PassPlan::PassPlan(const RenderSettings& settings)
    : most_samples_(settings.samples > 0 ? static_cast<std::uint32_t>(settings.samples) : most_samples),
      time_s_(settings.time_s),
      noise_(settings.noise > 0) {}

std::uint32_t PassPlan::next(std::uint32_t done) const noexcept {
    const std::uint32_t size = noise_ ? noise_pass : std::clamp(done, 1U, largest_pass);
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

void NoiseMeter::add_pass(std::size_t pixel, float luminance_sum, std::uint32_t samples) noexcept {
    const float mean = (luminance_sum - sums_[pixel]) / static_cast<float>(samples);
    sums_[pixel] = luminance_sum;
    squares_[pixel] += mean * mean;
}

bool NoiseMeter::quiet(const std::vector<std::size_t>& pixels, std::uint32_t passes, std::uint32_t samples,
                       double mean) const noexcept {
    if (passes < fewest_noise_passes) return false;
    double variance = 0, luminance = 0;
    for (const std::size_t pixel : pixels) {
        const double m = static_cast<double>(sums_[pixel]) / passes / samples;
        luminance += m;
        variance += std::max(0.0, static_cast<double>(squares_[pixel]) / passes - m * m) / (passes - 1);
    }
    const auto n = static_cast<double>(pixels.size());
    const double level = std::max(luminance / n, dark_share * mean);
    return std::sqrt(variance / n) <= limit_ * level;
}

}  // namespace cardioid

#include "rt_core/render/stop_rule.hpp"

#include <algorithm>

namespace cardioid {

namespace {

constexpr std::uint32_t largest_pass = 16;
/// Samples a pixel where only time or noise ends a render.
constexpr std::uint32_t fallback_samples = 1U << 20;

}  // namespace

PassPlan::PassPlan(const RenderSettings& settings)
    : most_samples_(settings.samples > 0 ? static_cast<std::uint32_t>(settings.samples) : fallback_samples),
      time_s_(settings.time_s) {
    // Half of each pixel's samples come from one sequence, half from the other.
    if (settings.noise > 0) most_samples_ += most_samples_ % 2;
}

std::uint32_t PassPlan::next(std::uint32_t done) const noexcept {
    return std::min(std::clamp(done, 1U, largest_pass), most_samples_ - std::min(done, most_samples_));
}

bool PassPlan::time_is_up() const noexcept { return time_s_ > 0 && seconds() >= time_s_; }

double PassPlan::seconds() const noexcept {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

double PassPlan::share(double done, double noise_share) const noexcept {
    const double time = time_s_ > 0 ? seconds() / time_s_ : 0;
    return std::min(1.0, std::max({done / most_samples_, time, noise_share}));
}

}  // namespace cardioid

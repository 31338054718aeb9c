#pragma once
#include <chrono>
#include <cstdint>

#include "rt_core/render/renderer.hpp"

namespace cardioid {

/// How many samples the next pass takes where no noise is asked for, and whether time is up. Passes double until they
/// have 16 samples, so that an interrupted picture is even.
class PassPlan {
public:
    explicit PassPlan(const RenderSettings& settings);
    /// Most samples a pixel; even where a noise is asked for.
    [[nodiscard]] std::uint32_t most_samples() const noexcept { return most_samples_; }
    /// Samples of the pass that begins after `done`; 0 when none is left.
    [[nodiscard]] std::uint32_t next(std::uint32_t done) const noexcept;
    [[nodiscard]] bool time_is_up() const noexcept;
    /// Since the plan was made.
    [[nodiscard]] double seconds() const noexcept;
    /// Share of the work in [0, 1] once `done` samples a pixel are there, of which a noise asked for needs
    /// `noise_share`.
    [[nodiscard]] double share(double done, double noise_share) const noexcept;

private:
    std::uint32_t most_samples_;
    double time_s_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace cardioid

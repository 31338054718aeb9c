#pragma once
#include <chrono>
#include <vector>

#include "rt_core/api/lighting.hpp"

namespace cardioid::photon {

/// Passes progress on and notes how long each phase took, by the clock on the wall. begin() and statistics() are for
/// one thread.
class PhaseTimes final : public Progress {
public:
    explicit PhaseTimes(Progress& inner) : inner_(inner) {}

    void begin(std::string_view phase) override {
        close();
        phases_.emplace_back("seconds " + std::string(phase), 0.0);
        inner_.begin(phase);
    }
    void update(double share) override { inner_.update(share); }
    [[nodiscard]] bool interrupted() const noexcept override { return inner_.interrupted(); }
    void log(int level, std::string_view text) override { inner_.log(level, text); }

    /// "seconds PHASE" of every phase, the last one until now.
    [[nodiscard]] std::vector<Statistic> statistics() {
        close();
        return phases_;
    }

private:
    using Clock = std::chrono::steady_clock;
    void close() {
        const auto now = Clock::now();
        if (!phases_.empty())
            std::get<double>(phases_.back().second) += std::chrono::duration<double>(now - since_).count();
        since_ = now;
    }

    Progress& inner_;
    std::vector<Statistic> phases_;
    Clock::time_point since_ = Clock::now();
};

}  // namespace cardioid::photon

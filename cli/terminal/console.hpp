#pragma once
#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

#include "rt_core/api/progress.hpp"

namespace cardioid::cli {

/// How much is told on standard error besides errors.
enum class Loudness { quiet, normal, verbose };

/// How progress is shown: a bar that is drawn over, a line every few seconds, or not.
enum class ProgressStyle { bar, lines, none };

/// The style for "auto", "bar", "lines", "none": auto is a bar on a terminal, else lines; quiet shows none.
ProgressStyle progress_style(const std::string& name, Loudness loudness);

/// Standard error: progress with the time left, warnings, and lines for -v. Any thread may call it.
class Console final : public Progress {
public:
    Console(Loudness loudness, ProgressStyle style);
    ~Console() override;
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    void begin(std::string_view phase) override;
    void update(double share) override;
    [[nodiscard]] bool interrupted() const noexcept override;
    void log(int level, std::string_view text) override;

    /// "cardioid: warning: text", unless quiet.
    void warn(std::string_view text);
    /// A line that tells what was done, unless quiet.
    void tell(std::string_view text);
    [[nodiscard]] bool verbose() const { return loudness_ == Loudness::verbose; }

private:
    using Clock = std::chrono::steady_clock;
    void draw(double share, double elapsed_s);
    void clear();
    void line(std::string_view text);

    Loudness loudness_;
    ProgressStyle style_;
    std::mutex mutex_;
    std::string phase_;
    Clock::time_point phase_begin_{Clock::now()};
    std::atomic<Clock::rep> next_draw_{0};  ///< earlier updates return at once
    std::size_t drawn_ = 0;                 ///< width of the bar on the terminal, 0: none
};

}  // namespace cardioid::cli

#include "cli/terminal/console.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

#include "cli/terminal/interrupt.hpp"

namespace cardioid::cli {
namespace {

constexpr int bar_width = 30;
constexpr std::chrono::milliseconds bar_interval{100}, line_interval{5000};

/// A closed standard error must not end a render, so failures are passed over.
void put(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

/// "0:07", "12:30", "3:05:00".
std::string clock_time(double seconds) {
    const long s = std::lround(seconds);
    if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
    return fmt::format("{}:{:02}", s / 60, s % 60);
}

/// "12:30 left", or nothing while too little is done to tell.
std::string time_left(double share, double elapsed_s) {
    if (share < 0.01 || elapsed_s < 0.5) return "";
    return clock_time(elapsed_s * (1 - share) / share) + " left";
}

}  // namespace

ProgressStyle progress_style(const std::string& name, Loudness loudness) {
    if (loudness == Loudness::quiet || name == "none") return ProgressStyle::none;
    if (name == "bar") return ProgressStyle::bar;
    if (name == "lines") return ProgressStyle::lines;
    return isatty(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::lines;
}

Console::Console(Loudness loudness, ProgressStyle style) : loudness_(loudness), style_(style) {}

Console::~Console() { clear(); }

void Console::begin(std::string_view phase) {
    const std::lock_guard lock(mutex_);
    clear();
    phase_ = phase;
    if (verbose()) line(phase_);
    phase_begin_ = Clock::now();
    const Clock::duration wait = style_ == ProgressStyle::bar ? Clock::duration(bar_interval) : line_interval;
    next_draw_ = (phase_begin_ + wait).time_since_epoch().count();
}

void Console::update(double share) {
    if (style_ == ProgressStyle::none) return;
    if (Clock::now().time_since_epoch().count() < next_draw_.load(std::memory_order_relaxed)) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock) return;
    const auto now = Clock::now();
    const Clock::duration wait = style_ == ProgressStyle::bar ? Clock::duration(bar_interval) : line_interval;
    next_draw_ = (now + wait).time_since_epoch().count();
    draw(std::clamp(share, 0.0, 1.0), std::chrono::duration<double>(now - phase_begin_).count());
}

bool Console::interrupted() const noexcept { return cli::interrupted(); }

void Console::draw(double share, double elapsed_s) {
    const std::string left = time_left(share, elapsed_s);
    if (style_ == ProgressStyle::lines) {
        line(fmt::format("{} {:.0f} %{}{}", phase_, share * 100, left.empty() ? "" : ", ", left));
        return;
    }
    const auto full = static_cast<std::size_t>(share * bar_width);
    const std::string bar =
        fmt::format("{} [{:<{}}] {:3.0f} % {}", phase_, std::string(full, '#'), bar_width, share * 100, left);
    put(fmt::format("\r{:<{}}", bar, drawn_));
    drawn_ = std::max(drawn_, bar.size());
}

void Console::clear() {
    if (drawn_ == 0) return;
    put(fmt::format("\r{:{}}\r", "", drawn_));
    drawn_ = 0;
}

void Console::line(std::string_view text) { put(fmt::format("{}\n", text)); }

void Console::log(int level, std::string_view text) {
    if (level == 0) return warn(text);
    if (!verbose()) return;
    const std::lock_guard lock(mutex_);
    clear();
    line(text);
}

void Console::warn(std::string_view text) {
    if (loudness_ == Loudness::quiet) return;
    const std::lock_guard lock(mutex_);
    clear();
    put(fmt::format("cardioid: warning: {}\n", text));
}

void Console::tell(std::string_view text) {
    if (loudness_ == Loudness::quiet) return;
    const std::lock_guard lock(mutex_);
    clear();
    line(text);
}

}  // namespace cardioid::cli

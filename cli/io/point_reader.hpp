#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rt_core/render/probe.hpp"

namespace cardioid::cli {

/// The point of a line "x y z nx ny nz"; blanks, tabs or commas stand between the numbers, the rest after '#' is
/// comment. Nothing where the line has no more. Throws Error(bad_input) with `file`:`line`:column.
std::optional<ProbePoint> parse_point(std::string_view text, const std::string& file, std::uint64_t line);

/// Points of a file, or of standard input for "-", a part at a time, so that there may be any number of them.
class PointReader {
public:
    /// Throws Error(io).
    explicit PointReader(const std::string& file);
    ~PointReader();
    PointReader(const PointReader&) = delete;
    PointReader& operator=(const PointReader&) = delete;

    /// The next points: of a pipe those that have arrived, as soon as there are any. False at the end, and where the
    /// user interrupts the wait. Throws Error(bad_input, io).
    bool read(std::vector<ProbePoint>& points);

private:
    void fill();
    void take_lines(std::vector<ProbePoint>& points);

    std::string file_, name_;
    int descriptor_ = -1;
    bool ended_ = false;
    std::uint64_t line_ = 0;
    std::string text_;  ///< read, but not taken yet
};

/// How many points a regular file has, after a look at every line; nothing of pipes, which can be read only once.
/// Throws Error(bad_input, io).
std::optional<std::uint64_t> count_points(const std::string& file);

}  // namespace cardioid::cli

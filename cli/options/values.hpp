#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rt_core/math/vec.hpp"

namespace cardioid::cli {

// What is written after an option, as a value. Each takes the option's name for its message and throws Error(usage)
// that says what was found and what was wanted.

double to_number(std::string_view option, std::string_view text, double lo = -std::numeric_limits<double>::infinity(),
                 double hi = std::numeric_limits<double>::infinity());
std::int64_t to_integer(std::string_view option, std::string_view text, std::int64_t lo, std::int64_t hi);
/// A whole number of at least 1: "20000", "1e8", "2.5e6", or of thousands, millions or thousand millions: "20k",
/// "2.5M", "1G".
std::int64_t to_count(std::string_view option, std::string_view text);
/// Numbers with commas between, in brackets or without.
std::vector<double> to_numbers(std::string_view option, std::string_view text, std::size_t count,
                               std::string_view wanted);
/// "x,y,z".
Vec3d to_vector(std::string_view option, std::string_view text);
/// Width and height [pixels]: "640x480", or "400" for a square.
std::array<int, 2> to_size(std::string_view option, std::string_view text);
/// Seconds: "30s", "2m", "1.5h", or plain seconds.
double to_seconds(std::string_view option, std::string_view text);
/// A share of 1: "2%" or "0.02".
double to_share(std::string_view option, std::string_view text);
/// Words with commas between.
std::vector<std::string> to_list(std::string_view text);
bool to_boolean(std::string_view option, std::string_view text);

/// `text` if it is one of `choices`, else an error with all of them and the nearest.
std::string to_choice(std::string_view option, std::string_view text, std::span<const std::string> choices);

/// "a, b or c".
std::string either(std::span<const std::string> choices);
/// ` (did you mean "x"?)`, or "".
std::string suggestion(std::string_view name, std::span<const std::string> choices);

}  // namespace cardioid::cli

#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cardioid {

/// The candidate with the fewest edits (insert, delete, replace, swap neighbours) from `name`, or "" where more than a
/// third of its letters would change. Case does not count.
std::string nearest_name(std::string_view name, std::span<const std::string_view> candidates);

/// ` (did you mean "sphere"?)`, or "" where nothing is near.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace cardioid

#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace cardioid::cli {

/// The tables of a TOML file as JSON, as far as files of limits need them: comments, [tables], keys that are bare or in
/// quotes, and on one line each numbers, true, false, texts and lists of these. Throws Error(bad_input) with the line.
nlohmann::json parse_limits_toml(const std::string& path, const std::string& text);

}  // namespace cardioid::cli

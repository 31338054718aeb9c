#pragma once
#include <nlohmann/json.hpp>

#include "cli/compare/verdict.hpp"

namespace cardioid::cli {

/// The figures of a region, and the limits held against them, as both --json and the report's page have them.
nlohmann::ordered_json figures_json(const RegionFigures& figures);
nlohmann::ordered_json checks_json(const Verdict& verdict);

}  // namespace cardioid::cli

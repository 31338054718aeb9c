#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "rt_core/render/measure/energy_ledger.hpp"

namespace cardioid::cli {

/// The ledger for --stats: each flux as {"rgb": [r, g, b], "sum": s} in W.
nlohmann::ordered_json energy_json(const EnergyLedger& ledger);

/// The ledger for -v: the balance, then the materials, those that take most first.
std::vector<std::string> energy_lines(const EnergyLedger& ledger);

}  // namespace cardioid::cli

#include "cli/commands/energy_report.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace cardioid::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_told = 20;  ///< materials that are printed

Json flux_json(const Flux& flux) { return {{"rgb", flux.channel}, {"sum", flux.sum()}}; }

double share(double part, double whole) { return whole > 0 ? 100 * part / whole : 0; }

}  // namespace

Json energy_json(const EnergyLedger& ledger) {
    Json absorbed = Json::array();
    for (const MaterialFlux& m : ledger.absorbed)
        absorbed.push_back({{"material", m.material},
                            {"received", flux_json(m.received)},
                            {"absorbed", flux_json(m.absorbed)},
                            {"standard_error", m.error}});
    return {{"power_of_lights", flux_json(ledger.power)},
            {"emitted", flux_json(ledger.emitted)},
            {"absorbed", flux_json(ledger.absorbed_in_all())},
            {"escaped", flux_json(ledger.escaped)},
            {"cut_off", flux_json(ledger.cut_off)},
            {"imbalance", ledger.imbalance()},
            {"paths", ledger.paths},
            {"bad_paths", ledger.bad_paths},
            {"absorbed_by", absorbed}};
}

std::vector<std::string> energy_lines(const EnergyLedger& ledger) {
    const double emitted = ledger.emitted.sum();
    std::vector<std::string> lines;
    lines.push_back(fmt::format("energy: {:.6g} W of light = {:.6g} absorbed + {:.6g} escaped + {:.3g} cut off",
                                emitted, ledger.absorbed_in_all().sum(), ledger.escaped.sum(), ledger.cut_off.sum()));
    std::vector<const MaterialFlux*> order;
    for (const MaterialFlux& m : ledger.absorbed) order.push_back(&m);
    std::stable_sort(order.begin(), order.end(), [](const MaterialFlux* a, const MaterialFlux* b) {
        return a->absorbed.sum() > b->absorbed.sum();
    });
    const std::size_t told = std::min(order.size(), most_told);
    for (std::size_t i = 0; i < told; ++i)
        lines.push_back(fmt::format("absorbed by {}: {:.4g} W, {:.1f} %", order[i]->material, order[i]->absorbed.sum(),
                                    share(order[i]->absorbed.sum(), emitted)));
    if (told < order.size()) lines.push_back(fmt::format("... and by {} more materials", order.size() - told));
    return lines;
}

}  // namespace cardioid::cli

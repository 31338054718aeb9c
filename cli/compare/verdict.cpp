#include "cli/compare/verdict.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace cardioid::cli {
namespace {

void hold(const LimitKind& kind, double allowed, const RegionFigures& figures, Verdict& verdict) {
    if (figures.pixels == 0) return;
    const std::string where = figures.name == "all" ? "" : " of " + figures.name;
    verdict.checks.push_back({kind.name + where, kind.value(figures), allowed});
}

std::string described(const Verdict& verdict, const Comparison& comparison) {
    if (comparison.bad > 0)
        return fmt::format("{} pixels are not finite, the first at {}, {}", comparison.bad, comparison.first_bad[0],
                           comparison.first_bad[1]);
    if (verdict.checks.empty())
        return verdict.good ? "the same to the last bit" : "they differ, and no limit says by how much they may";
    const auto failed =
        std::count_if(verdict.checks.begin(), verdict.checks.end(), [](const LimitCheck& c) { return !c.good(); });
    if (failed == 0) return fmt::format("within all {} limits", verdict.checks.size());
    const auto first =
        std::find_if(verdict.checks.begin(), verdict.checks.end(), [](const LimitCheck& c) { return !c.good(); });
    return fmt::format("beyond {} of {} limits: {} is {:.4g}, allowed {:.4g}", failed, verdict.checks.size(),
                       first->name, first->found, first->allowed);
}

}  // namespace

Verdict judge(const Comparison& comparison, const CompareOptions& options) {
    Verdict verdict;
    for (const LimitKind& kind : limit_kinds()) {
        const auto limit = options.limits.find(kind.name);
        if (limit == options.limits.end()) continue;
        hold(kind, limit->second, comparison.whole, verdict);
        if (!kind.every_region) continue;
        for (const RegionFigures& region : comparison.regions) hold(kind, limit->second, region, verdict);
    }
    verdict.good =
        comparison.bad == 0 && (options.limits.empty() ? comparison.whole.max == 0
                                                       : std::all_of(verdict.checks.begin(), verdict.checks.end(),
                                                                     [](const LimitCheck& c) { return c.good(); }));
    verdict.text = described(verdict, comparison);
    return verdict;
}

}  // namespace cardioid::cli

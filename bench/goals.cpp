#include "bench/goals.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

#include "rt_core/api/error.hpp"

namespace cardioid::bench {
namespace {

/// By how much a figure is better (or worse) than its goal.
std::string verdict(double met_times) {
    return met_times >= 1 ? fmt::format("met, {:.0f} % over", 100 * (met_times - 1))
                          : fmt::format("MISSED by {:.0f} %", 100 * (1 - met_times));
}

}  // namespace

void GoalReporter::ReportRuns(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
        const auto counter = run.counters.find("items_per_second");
        if (run.aggregate_name == "median" && counter != run.counters.end())
            rates_[run.run_name.function_name] = counter->second;
    }
    ConsoleReporter::ReportRuns(runs);
}

double GoalReporter::rate(const std::string& name) const {
    const auto found = rates_.find(name);
    return found == rates_.end() ? 0 : found->second;
}

void GoalReporter::print(const std::vector<Goal>& goals, const std::vector<Bound>& bounds) const {
    fmt::print("\n{:<34}{:>8}  {:<28}{:>8}{:>8}{:>8}\n", "million rays a CPU second", "", "yardstick", "", "ratio",
               "goal");
    for (const Goal& goal : goals) {
        const double subject = rate(goal.subject), yardstick = rate(goal.yardstick);
        if (subject == 0 || yardstick == 0) continue;
        fmt::print("{:<34}{:>8.2f}  {:<28}{:>8.2f}{:>8.3f}{:>8.3f}  {}\n", goal.subject, subject / 1e6, goal.yardstick,
                   yardstick / 1e6, subject / yardstick, goal.ratio, verdict(subject / yardstick / goal.ratio));
    }
    fmt::print("\n{:<62}{:>10}{:>10}\n", "memory", "value", "at most");
    for (const Bound& b : bounds)
        fmt::print("{:<62}{:>10.2f}{:>10.2f}  {}\n", b.what, b.value, b.most, verdict(b.most / b.value));
    std::fflush(stdout);
}

void GoalReporter::write(const std::string& path, const std::vector<Goal>& goals,
                         const std::vector<Bound>& bounds) const {
    using Json = nlohmann::ordered_json;
    Json json{{"unit", "items a CPU second"}, {"speed", Json::array()}, {"memory", Json::array()}};
    for (const Goal& goal : goals) {
        const double subject = rate(goal.subject), yardstick = rate(goal.yardstick);
        if (subject == 0 || yardstick == 0) continue;
        json["speed"].push_back({{"subject", goal.subject},
                                 {"rate", subject},
                                 {"yardstick", goal.yardstick},
                                 {"yardstick_rate", yardstick},
                                 {"ratio", subject / yardstick},
                                 {"goal", goal.ratio},
                                 {"met", subject / yardstick >= goal.ratio}});
    }
    for (const Bound& b : bounds)
        json["memory"].push_back(
            {{"what", b.what}, {"value", b.value}, {"at_most", b.most}, {"met", b.value <= b.most}});
    std::ofstream file(path);
    file << json.dump(2) << '\n';
    if (!file.flush()) throw Error(ErrorCode::io, "cannot write " + path);
}

}  // namespace cardioid::bench

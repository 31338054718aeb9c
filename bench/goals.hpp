#pragma once
#include <benchmark/benchmark.h>
#include <map>
#include <string>
#include <vector>

namespace cardioid::bench {

/// A benchmark is to reach a share of what another one reaches in the same run.
struct Goal {
    std::string subject, yardstick;  ///< names of benchmarks that count items per second
    double ratio;
};

/// A figure that does not come from a clock; it is to stay at or below `most`.
struct Bound {
    std::string what;
    double value, most;
};

/// Prints the benchmarks as Google Benchmark does and remembers the items per CPU second of each.
class GoalReporter final : public benchmark::ConsoleReporter {
public:
    GoalReporter() : benchmark::ConsoleReporter(OO_Tabular) {}
    void ReportRuns(const std::vector<Run>& runs) override;
    /// How far each goal is met or missed, as a table on standard output; goals that were not run are left out.
    void print(const std::vector<Goal>& goals, const std::vector<Bound>& bounds) const;
    /// The same as JSON. Throws Error(io).
    void write(const std::string& path, const std::vector<Goal>& goals, const std::vector<Bound>& bounds) const;

private:
    /// Median over the repetitions, items per CPU second; 0 where it was not run.
    [[nodiscard]] double rate(const std::string& name) const;

    std::map<std::string, double> rates_;
};

}  // namespace cardioid::bench

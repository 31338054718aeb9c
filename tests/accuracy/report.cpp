/// accuracy_report MODULE [TEXT]: measures the known values whose title has TEXT in it, with the tolerances of the long
/// run, and prints a table of Markdown; for scripts/accuracy. Its status is 1 where a value misses.
#include <cstdio>
#include <fmt/format.h>
#include <string>
#include <utility>

#include "rt_core/api/error.hpp"
#include "rt_core/api/parallel.hpp"
#include "tests/accuracy/verdict.hpp"

namespace {

using namespace cardioid;
using namespace cardioid::test;

std::string percent(double share) { return fmt::format("{:.3g} %", share * 100); }

std::string row(const KnownValue& known, const Verdict& verdict) {
    const char* word = verdict.good() ? "right" : verdict.right ? "not sure enough" : "**misses**";
    const auto share = [&](double value) {
        return known.expected == 0 ? fmt::format("{:.3g}", value) : percent(value);
    };
    return fmt::format("| {} | {:.6g} | {:.6g} | {} | {} | {} | {:.1f} s | {} |\n", known.name, known.expected,
                       verdict.found.value, share(verdict.error), share(verdict.standard_error), share(known.tolerance),
                       verdict.found.cpu_s, word);
}

std::string heading(const KnownValue& known) {
    return fmt::format(
        "\n### {}, `{}`\n{}.\n\n| value | expected | found | error | standard error | tolerance | CPU time | |\n"
        "|---|---|---|---|---|---|---|---|\n",
        known.section, known.scene, known.source);
}

struct Tally {
    int values = 0, good = 0;
    double square = 0, cpu_s = 0;
    void add(const KnownValue& known, const Verdict& verdict) {
        ++values;
        good += verdict.good();
        cpu_s += verdict.found.cpu_s;
        if (known.expected != 0) square += verdict.error * verdict.error;
    }
};

std::vector<KnownValue> chosen(const std::string& module, const std::string& text) {
    std::vector<KnownValue> some;
    for (const KnownValue& known : known_values(module, true))
        if (known.title().find(text) != std::string::npos) some.push_back(known);
    return some;
}

int report(const std::string& module, const std::string& text) {
    const std::vector<KnownValue> values = chosen(module, text);
    std::vector<Verdict> verdicts(values.size());
    parallel_for(static_cast<std::int64_t>(values.size()), [&](std::int64_t i) {
        const auto at = static_cast<std::size_t>(i);
        verdicts[at] = judge(values[at], module);
        fmt::print(stderr, "{}: {:+.4f} %\n", values[at].title(), verdicts[at].error * 100);
    });
    Tally tally;
    std::string head;
    for (std::size_t i = 0; i < values.size(); ++i) {
        tally.add(values[i], verdicts[i]);
        if (std::exchange(head, heading(values[i])) != heading(values[i])) fmt::print("{}", head);
        fmt::print("{}", row(values[i], verdicts[i]));
    }
    fmt::print(
        "\n{} of {} values are right; the root of their mean squared errors is {}. All took {:.0f} CPU seconds.\n",
        tally.good, tally.values, percent(std::sqrt(tally.square / std::max(1, tally.values))), tally.cpu_s);
    return tally.good == tally.values ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
    try {
        if (count >= 2 && count <= 3) return report(words[1], count == 3 ? words[2] : "");
        std::fputs("usage: accuracy_report MODULE [TEXT]\n", stderr);
    } catch (const Error& error) {
        fmt::print(stderr, "accuracy_report: {}\n", error.what());
    }
    return 2;
}

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

std::string row(const KnownValue& known, const std::string& module, const Verdict& verdict) {
    const char* word = verdict.good() ? "right" : verdict.sure ? "**misses**" : "not sure enough";
    const auto share = [&](double value) {
        return known.expected == 0 ? fmt::format("{:.3g}", value) : percent(value);
    };
    return fmt::format("| {} | {:.6g} | {:.6g} | {} | {} | {} | {:.1f} s | {} |\n", known.name, known.expected,
                       verdict.found.value, share(verdict.error), share(verdict.standard_error),
                       share(known.tolerance(module)), verdict.found.cpu_s, word);
}

std::string heading(const KnownValue& known) {
    return fmt::format(
        "\n### {}, `{}`\n{}.\n\n| value | expected | found | error | standard error | tolerance | CPU time | |\n"
        "|---|---|---|---|---|---|---|---|\n",
        known.section, known.scene, known.source);
}

struct Tally {
    int values = 0, good = 0;
    double square = 0, worst = 0, cpu_s = 0;
    std::string worst_title;
    void add(const KnownValue& known, const std::string& module, const Verdict& verdict) {
        ++values;
        good += verdict.good();
        cpu_s += verdict.found.cpu_s;
        if (known.expected == 0) return;
        square += verdict.error * verdict.error;
        const double share = std::abs(verdict.error) / known.tolerance(module);
        if (share > worst) worst = share, worst_title = known.title();
    }
};

std::vector<Setting> chosen(const std::string& module, const std::string& text) {
    std::vector<Setting> some;
    for (Setting& setting : known_settings(module, Run::whole)) {
        std::erase_if(setting, [&](const KnownValue& known) { return known.title().find(text) == std::string::npos; });
        if (!setting.empty()) some.push_back(std::move(setting));
    }
    return some;
}

int report(const std::string& module, const std::string& text) {
    const std::vector<Setting> settings = chosen(module, text);
    std::vector<std::vector<Verdict>> verdicts(settings.size());
    parallel_for(static_cast<std::int64_t>(settings.size()), [&](std::int64_t i) {
        const auto at = static_cast<std::size_t>(i);
        verdicts[at] = judge(settings[at], module);
        for (std::size_t k = 0; k < verdicts[at].size(); ++k)
            fmt::print(stderr, "{}{}", settings[at][k].section, row(settings[at][k], module, verdicts[at][k]));
    });
    Tally tally;
    std::string head;
    for (std::size_t i = 0; i < settings.size(); ++i)
        for (std::size_t k = 0; k < settings[i].size(); ++k) {
            const KnownValue& known = settings[i][k];
            tally.add(known, module, verdicts[i][k]);
            if (std::exchange(head, heading(known)) != heading(known)) fmt::print("{}", head);
            fmt::print("{}", row(known, module, verdicts[i][k]));
        }
    fmt::print(
        "\n{} of {} values are right; the root of their mean squared errors is {}. Nearest to its tolerance, or over "
        "it: "
        "{}, with {:.0f} % of it. All took {:.0f} CPU seconds.\n",
        tally.good, tally.values, percent(std::sqrt(tally.square / std::max(1, tally.values))), tally.worst_title,
        tally.worst * 100, tally.cpu_s);
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

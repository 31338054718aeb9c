/// accuracy_report MODULE [--only TEXT] [--results FILE] [--found]: measures the known values whose title has TEXT in
/// it, with the tolerances of the long run, and prints a table of Markdown; for scripts/accuracy. What has been
/// measured is kept in FILE and taken from there the next time, where the value's scene, parameters, place and
/// tolerance are still the same and it was sure, or had all the samples it may have; with --found nothing is measured,
/// and what is not in FILE is left out and counted. Its status is 1 where a value misses or is missing.
#include <cstdio>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>

#include "rt_core/api/error.hpp"
#include "rt_core/api/parallel.hpp"
#include "tests/accuracy/results.hpp"

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

struct Wish {
    std::string module, only, file;
    bool found = false;  ///< measure nothing
};

/// Paths prepare nothing, so that each value is measured, and kept, by itself.
std::vector<Setting> chosen(const Wish& wish) {
    std::vector<Setting> some;
    for (const Setting& setting : known_settings(wish.module, Run::whole)) {
        Setting part;
        for (const KnownValue& known : setting) {
            if (known.title().find(wish.only) == std::string::npos) continue;
            part.push_back(known);
            if (wish.module == "path") some.push_back(std::exchange(part, {}));
        }
        if (!part.empty()) some.push_back(std::move(part));
    }
    return some;
}

/// What is not known yet of these values.
void measure(Setting setting, const std::string& module, Results& results) {
    std::erase_if(setting, [&](const KnownValue& known) { return results.find(known, module).has_value(); });
    if (setting.empty()) return;
    const std::vector<Verdict> verdicts = judge(setting, module);
    for (std::size_t k = 0; k < setting.size(); ++k) {
        results.add(setting[k], module, verdicts[k]);
        fmt::print(stderr, "{} {}", setting[k].section, row(setting[k], module, verdicts[k]));
    }
}

int report(const Wish& wish) {
    const std::vector<Setting> settings = chosen(wish);
    Results results(wish.file);
    if (!wish.found)
        parallel_for(static_cast<std::int64_t>(settings.size()),
                     [&](std::int64_t i) { measure(settings[static_cast<std::size_t>(i)], wish.module, results); });
    Tally tally;
    std::string head;
    int missing = 0;
    for (const Setting& setting : settings)
        for (const KnownValue& known : setting) {
            const std::optional<Verdict> verdict = results.any(known, wish.module);
            if (!verdict) {
                ++missing;
                continue;
            }
            tally.add(known, wish.module, *verdict);
            if (std::exchange(head, heading(known)) != heading(known)) fmt::print("{}", head);
            fmt::print("{}", row(known, wish.module, *verdict));
        }
    fmt::print(
        "\n{} of {} values are right; the root of their mean squared errors is {}. Nearest to its tolerance, or over "
        "it: {}, with {:.0f} % of it. All took {:.0f} CPU seconds.\n",
        tally.good, tally.values, percent(std::sqrt(tally.square / std::max(1, tally.values))), tally.worst_title,
        tally.worst * 100, tally.cpu_s);
    if (missing > 0) fmt::print("\n{} values of the table have not been measured for this edition.\n", missing);
    return tally.good == tally.values && missing == 0 ? 0 : 1;
}

/// Nothing where the words make no sense.
std::optional<Wish> wish_of(int count, char** words) {
    if (count < 2) return std::nullopt;
    Wish wish{.module = words[1], .only = {}, .file = {}};
    for (int i = 2; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--found")
            wish.found = true;
        else if ((word == "--only" || word == "--results") && i + 1 < count)
            (word == "--only" ? wish.only : wish.file) = words[++i];
        else
            return std::nullopt;
    }
    return wish;
}

}  // namespace

int main(int count, char** words) {
    try {
        if (const auto wish = wish_of(count, words)) return report(*wish);
        std::fputs("usage: accuracy_report MODULE [--only TEXT] [--results FILE] [--found]\n", stderr);
    } catch (const Error& error) {
        fmt::print(stderr, "accuracy_report: {}\n", error.what());
    }
    return 2;
}

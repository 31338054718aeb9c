#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/compare/figures_json.hpp"
#include "cli/compare/verdict.hpp"

namespace cardioid::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Infinity and NaN have no place in JSON.
Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }
Json triple(Rgb c) { return {number(double{c.r}), number(double{c.g}), number(double{c.b})}; }

std::string line(const RegionFigures& f) {
    const double a = double{f.mean_a.r + f.mean_a.g + f.mean_a.b} / 3,
                 b = double{f.mean_b.r + f.mean_b.g + f.mean_b.b} / 3;
    std::string text = fmt::format(
        "{:<18} {:>9} {:>10.4g} {:>10.4g} {:>9.3g}% {:>10.4g} {:>10.4g} {:>10.4g} {:>10.4g} {:>11} {:>8.3g}% {:>9.4g}",
        f.name, f.pixels, a, b, 100 * f.bias, f.rmse, f.relative_mse, f.p999, f.max,
        fmt::format("{},{}", f.max_x, f.max_y), 100 * f.beyond, f.flip);
    if (f.z) text += fmt::format(" {:>7.2f}", *f.z);
    return text + "\n";
}

}  // namespace

Json figures_json(const RegionFigures& f) {
    Json json{{"name", f.name},
              {"pixels", f.pixels},
              {"mean_a", triple(f.mean_a)},
              {"mean_b", triple(f.mean_b)},
              {"bias", number(f.bias)},
              {"rmse", number(f.rmse)},
              {"relative_mse", number(f.relative_mse)},
              {"p999", number(f.p999)},
              {"max", number(f.max)},
              {"max_at", {f.max_x, f.max_y}},
              {"beyond", number(f.beyond)},
              {"flip", number(f.flip)}};
    if (f.z) json["z"] = number(*f.z);
    return json;
}

Json checks_json(const Verdict& verdict) {
    Json checks = Json::array();
    for (const LimitCheck& check : verdict.checks)
        checks.push_back({{"name", check.name},
                          {"found", number(check.found)},
                          {"allowed", number(check.allowed)},
                          {"good", check.good()}});
    return checks;
}

std::string comparison_text(const Comparison& comparison, const Verdict& verdict) {
    std::string text =
        fmt::format("{:<18} {:>9} {:>10} {:>10} {:>10} {:>10} {:>10} {:>10} {:>10} {:>11} {:>9} {:>9}{}\n", "region",
                    "pixels", "mean A", "mean B", "bias", "RMSE", "rel. MSE", "99.9 %", "largest", "at", "beyond",
                    "FLIP", comparison.whole.z ? "       z" : "");
    text += line(comparison.whole);
    for (const RegionFigures& region : comparison.regions) text += line(region);
    if (comparison.skipped > 0) text += fmt::format("{} pixels at outlines are left out\n", comparison.skipped);
    return text + verdict.text + "\n";
}

std::string comparison_json(const Comparison& comparison, const Verdict& verdict, const CompareOptions& options) {
    Json regions = Json::array();
    for (const RegionFigures& region : comparison.regions) regions.push_back(figures_json(region));
    const Json json{{"a", options.a},
                    {"b", options.b},
                    {"equal", verdict.good},
                    {"verdict", verdict.text},
                    {"checks", checks_json(verdict)},
                    {"whole", figures_json(comparison.whole)},
                    {"regions", regions},
                    {"skipped_pixels", comparison.skipped},
                    {"bad_pixels", comparison.bad}};
    return json.dump(2) + "\n";
}

}  // namespace cardioid::cli

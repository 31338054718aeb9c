#include "cli/commands/probe_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/version.hpp"

namespace cardioid::cli {
namespace {

using Json = nlohmann::ordered_json;

/// "3 of 10 points are", "1 of 10 points is".
std::string some_points(std::uint64_t some, std::uint64_t all) {
    return fmt::format("{} of {} point{} {}", some, all, all == 1 ? "" : "s", some == 1 ? "is" : "are");
}

std::string text_of(Rgb c) { return fmt::format("{}, {}, {}", c.r, c.g, c.b); }
std::string text_of(Vec3d v) { return fmt::format("{}, {}, {}", v.x, v.y, v.z); }

}  // namespace

void ProbeTotals::add(const Reading& reading) {
    ++points;
    samples += reading.samples;
    bad_samples += reading.bad_samples;
    buried += reading.buried;
    noisy += !reading.reached;
}

std::string reading_line(const Reading& r) {
    const Rgb se = r.standard_error;
    return fmt::format("{} {} {} {} {} {}\n", r.value.r, r.value.g, r.value.b, se.r, se.g, se.b);
}

std::string reading_json(const ProbePoint& point, const Reading& reading) {
    std::string text =
        fmt::format(R"({{"p": [{}], "d": [{}], "value": [{}], "standard_error": [{}], "samples": {})", text_of(point.p),
                    text_of(point.d), text_of(reading.value), text_of(reading.standard_error), reading.samples);
    if (reading.bad_samples > 0) text += fmt::format(R"(, "bad_samples": {})", reading.bad_samples);
    if (reading.buried) text += R"(, "buried": true)";
    if (!reading.reached) text += R"(, "reached": false)";
    return text + "}";
}

std::string json_head(const ProbeOptions& options, const LightingKind& lighting, const CommittedScene& scene) {
    const ProbeSettings settings = options.settings_for_probe();
    const bool radiance = settings.what == Quantity::radiance;
    Json head{{"cardioid", version()},
              {"scene", {{"file", options.scene.file}, {"hash", fmt::format("{:016x}", scene.hash())}}},
              {"what", radiance ? "radiance" : "irradiance"},
              {"unit", radiance ? "W/(sr unit^2)" : "W/unit^2"},
              {"lighting", lighting.name},
              {"seed", settings.seed}};
    if (settings.noise > 0) head["noise"] = settings.noise;
    if (settings.most_samples > 0) head["most_samples"] = settings.most_samples;
    // A file name need not be UTF-8; JSON must.
    const std::string text = head.dump(2, ' ', false, Json::error_handler_t::replace);
    return text.substr(0, text.rfind('\n')) + ",\n  \"points\": [";
}

std::string json_tail(const ProbeTotals& totals, const LightingModule& module) {
    Json lighting = Json::object();
    for (const auto& [name, value] : module.statistics())
        std::visit([&, &key = name](const auto& v) { lighting[key] = v; }, value);
    const Json json{{"points", totals.points},           {"samples", totals.samples},
                    {"bad_samples", totals.bad_samples}, {"buried_points", totals.buried},
                    {"noisy_points", totals.noisy},      {"seconds", totals.seconds},
                    {"interrupted", totals.interrupted}, {"lighting", lighting}};
    return "\n  ],\n  \"statistics\": " + json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n}\n";
}

std::vector<std::string> probe_warnings(const ProbeTotals& t) {
    std::vector<std::string> all;
    if (t.points == 0 && !t.interrupted) all.emplace_back("there is no point to measure");
    if (t.buried > 0)
        all.push_back(some_points(t.buried, t.points) + " inside opaque solids, where no light arrives: 0");
    if (t.noisy > 0 && !t.interrupted)
        all.push_back(some_points(t.noisy, t.points) + " noisier than asked after the most samples; see the errors");
    if (t.bad_samples > 0)
        all.push_back(fmt::format("{} samples were not finite or negative and count as black", t.bad_samples));
    return all;
}

std::vector<std::string> probe_lines(const ProbeTotals& t, const LightingModule& module) {
    std::vector<std::string> lines;
    lines.push_back(fmt::format("samples: {}, {:.0f} a second", t.samples,
                                t.seconds > 0 ? static_cast<double>(t.samples) / t.seconds : 0));
    for (const auto& [name, value] : module.statistics())
        std::visit([&, &key = name](const auto& v) { lines.push_back(fmt::format("{}: {}", key, v)); }, value);
    return lines;
}

}  // namespace cardioid::cli

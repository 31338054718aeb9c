#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <omp.h>

#include "cli/builtins.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/lighting_choice.hpp"
#include "cli/commands/probe_report.hpp"
#include "cli/io/point_reader.hpp"
#include "cli/io/stream_output.hpp"
#include "cli/io/text_output.hpp"
#include "cli/terminal/interrupt.hpp"
#include "csg/compile.hpp"

namespace cardioid::cli {
namespace {

/// Before any work: whatever is written at the end can be written, and nothing that is read is lost.
void check_outputs(const ProbeOptions& options) {
    for (const std::string& output : {options.output, options.json}) {
        if (output.empty()) continue;
        keep_scene(options.scene, output);
        std::error_code ignored;
        if (std::filesystem::is_regular_file(output, ignored) &&
            std::filesystem::equivalent(options.points, output, ignored))
            throw Error(ErrorCode::usage, fmt::format("{} has the points and would be overwritten", output));
        check_text_path(output);
    }
    keep_scene(options.scene, options.save_map, "--save-map");
    if (!options.save_map.empty()) check_text_path(options.save_map);
}

/// Progress over all points, of which some have been measured before this part.
class PartProgress final : public Progress {
public:
    PartProgress(Console& console, std::uint64_t before, std::uint64_t part, std::uint64_t all)
        : console_(console), before_(before), part_(part), all_(all) {}
    void update(double share) override {
        console_.update((static_cast<double>(before_) + share * static_cast<double>(part_)) /
                        static_cast<double>(all_));
    }
    [[nodiscard]] bool interrupted() const noexcept override { return console_.interrupted(); }

private:
    Console& console_;
    std::uint64_t before_, part_, all_;
};

/// Where readings go: lines, JSON or both.
class Outputs {
public:
    explicit Outputs(const ProbeOptions& options) {
        if (!options.output.empty()) lines_.emplace(options.output);
        if (!options.json.empty()) json_.emplace(options.json);
    }
    void begin(const std::string& json_head) {
        if (json_) json_->write(json_head);
    }
    void write(std::span<const ProbePoint> points, std::span<const Reading> readings) {
        std::string lines, json;
        for (std::size_t i = 0; i < readings.size(); ++i) {
            if (lines_) lines += reading_line(readings[i]);
            if (json_) json += (any_ ? ",\n    " : "\n    ") + reading_json(points[i], readings[i]);
            any_ = true;
        }
        if (lines_) lines_->write(lines);
        if (json_) json_->write(json);
    }
    void end(const std::string& json_tail) {
        if (json_) json_->write(json_tail);
        if (lines_) lines_->finish();
        if (json_) json_->finish();
    }

private:
    std::optional<StreamOutput> lines_, json_;
    bool any_ = false;
};

/// Readings that there are, up to the first point that an interrupt left out.
std::size_t measured(std::span<const Reading> readings) {
    const auto missing =
        std::find_if(readings.begin(), readings.end(), [](const Reading& r) { return r.samples == 0 && !r.buried; });
    return static_cast<std::size_t>(missing - readings.begin());
}

/// Reads, measures and writes part by part.
ProbeTotals measure_all(const ProbeOptions& options, std::optional<std::uint64_t> count, const CommittedScene& scene,
                        const LightingModule& module, Outputs& outputs, Console& console) {
    ProbeSettings settings = options.settings_for_probe();
    ProbeTotals totals;
    PointReader reader(options.points);
    const auto begin = std::chrono::steady_clock::now();
    console.begin("probe");
    for (std::vector<ProbePoint> points; !interrupted() && reader.read(points);) {
        // Of a pipe nobody knows how much is to come: as much again as there has been.
        const std::uint64_t all = count.value_or(2 * (settings.first + points.size()));
        PartProgress progress(console, settings.first, points.size(), all);
        const std::vector<Reading> readings = probe(scene, module, points, settings, progress);
        const std::span<const Reading> done = std::span(readings).first(measured(readings));
        for (const Reading& reading : done) totals.add(reading);
        outputs.write(points, done);
        settings.first += points.size();
    }
    totals.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    totals.interrupted = interrupted();
    return totals;
}

void prepare_lighting(LightingModule& module, const ProbeOptions& options, const CommittedScene& scene,
                      Console& console) {
    if (!options.load_map.empty())
        module.load(options.load_map, scene, nullptr, console);
    else
        module.prepare(scene, nullptr, console);
    if (!options.save_map.empty() && !interrupted()) module.save(options.save_map);
}

void warn_all(const std::vector<std::string>& warnings, Console& console) {
    for (const std::string& warning : warnings) console.warn(warning);
}

int probe_scene(const ProbeOptions& options, Console& console) {
    const std::unique_ptr<Registry> registry = open_registry(options.scene.plugins);
    console.begin("read");
    Scene scene = read_scene(options.scene, *registry);
    warn_all(scene.warnings, console);
    LightingChoice choice = choose_lighting(options, scene, *registry);
    end_straight_shadows(scene, choice);
    warn_all(choice.warnings, console);
    const std::unique_ptr<LightingModule> module = make_lighting(choice, options.seed);
    // A wrong line late in the file must not come up after hours.
    const std::optional<std::uint64_t> count = count_points(options.points);

    console.begin("build");
    const CommittedScene committed(scene, *registry, csg::compile, {.studio = false, .ground = options.ground});
    warn_all(committed.warnings(), console);

    catch_interrupts();  // until here there was nothing to save
    prepare_lighting(*module, options, committed, console);
    if (interrupted()) throw Error(ErrorCode::interrupted, "interrupted before the first point; nothing is saved");
    Outputs outputs(options);
    outputs.begin(json_head(options, *choice.kind, committed));
    const ProbeTotals totals = measure_all(options, count, committed, *module, outputs, console);
    outputs.end(json_tail(totals, *module));

    warn_all(probe_warnings(totals), console);
    if (console.verbose())
        for (const std::string& line : probe_lines(totals, *module)) console.log(1, line);
    console.tell(fmt::format("{}: {} point{}, {} samples, {:.1f} s", options.points == "-" ? "<stdin>" : options.points,
                             totals.points, totals.points == 1 ? "" : "s", totals.samples, totals.seconds));
    if (!totals.interrupted) return 0;
    throw Error(ErrorCode::interrupted, fmt::format("interrupted; the first {} points have been measured, the last of "
                                                    "them less well than asked",
                                                    totals.points));
}

}  // namespace

int run_probe(const std::vector<std::string>& words) {
    const std::optional<ProbeOptions> options = parse_probe_options(words);
    if (!options) return 0;
    check_outputs(*options);
    if (options->threads > 0) omp_set_num_threads(options->threads);
    Console console(options->loudness(), progress_style(options->progress, options->loudness()));
    return probe_scene(*options, console);
}

}  // namespace cardioid::cli

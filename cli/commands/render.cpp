#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <omp.h>

#include "cli/builtins.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/lighting_choice.hpp"
#include "cli/commands/render_report.hpp"
#include "cli/commands/render_settings.hpp"
#include "cli/io/text_output.hpp"
#include "cli/terminal/interrupt.hpp"
#include "csg/compile.hpp"
#include "rt_core/render/picture_eye.hpp"

namespace cardioid::cli {
namespace {

/// Wall clock time of the phases of a render.
class Stopwatch {
public:
    /// Seconds since the last call, under this name.
    void lap(const std::string& phase) {
        const auto now = std::chrono::steady_clock::now();
        phases_s.emplace_back(phase, std::chrono::duration<double>(now - last_).count());
        last_ = now;
    }
    std::vector<std::pair<std::string, double>> phases_s;

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Before any work: whatever is written at the end can be written.
void check_outputs(const RenderOptions& options) {
    keep_scene(options.scene, options.output);
    keep_scene(options.scene, options.stats, "--stats");
    keep_scene(options.scene, options.save_map, "--save-map");
    check_image_path(options.output);
    if (!options.stats.empty()) check_text_path(options.stats);
    if (!options.save_map.empty()) check_text_path(options.save_map);
}

/// Pictures of the photons themselves need them, and they would be dropped once the cache stands.
void keep_what_is_shown(const std::string& view, LightingChoice& choice) {
    const bool shown = view == "photons" || view == "map" || view == "lookup";
    if (!shown || choice.kind->name != std::string_view("photon") || choice.params.has("keep_map")) return;
    choice.params.set("keep_map", ParamValue{.kind = ParamValue::Kind::boolean, .boolean = true});
}

/// csg::compile that also measures the model: its box without lamps and ground.
CompileSolids measuring_compiler(Box3d& model) {
    return [&model](const Scene& scene, const std::vector<bool>& transparent) {
        Geometry geometry = csg::compile(scene, transparent);
        model.include(bounded_box(geometry));
        return geometry;
    };
}

void prepare_lighting(LightingModule& module, const RenderOptions& options, const CommittedScene& scene,
                      const RenderSettings& settings, Console& console) {
    const PictureEye eye(scene, settings);
    if (!options.load_map.empty())
        module.load(options.load_map, scene, &eye, console);
    else
        module.prepare(scene, &eye, console);
    if (!options.save_map.empty() && !interrupted()) module.save(options.save_map);
}

/// A quick picture is drawn by few threads: to start one, and what it waits for work, takes as long as direct light for
/// so many samples.
void leave_threads_asleep(const RenderOptions& options, const RenderSettings& settings, const LightingKind& lighting) {
    constexpr std::int64_t samples_a_thread = 20'000;
    const bool quick = lighting.name == std::string_view("direct") || lighting.name == std::string_view("whitted");
    if (options.threads > 0 || !quick || settings.time_s > 0 || settings.noise > 0) return;
    const std::int64_t samples = std::int64_t{settings.width} * settings.height * settings.samples;
    if (const std::int64_t worth = 1 + samples / samples_a_thread; worth < omp_get_max_threads())
        omp_set_num_threads(static_cast<int>(worth));
}

void write_picture(const RenderReport& report, const Film& film) {
    ImageWriteSettings settings;
    settings.exposure = report.options.exposure.value_or(report.scene.film.exposure);
    settings.half = report.options.half;
    settings.metadata = picture_metadata(report);
    write_image(report.options.output, film, settings);
}

bool is_black(const Film& film) {
    const std::vector<float>& pixels = film.layers.front().pixels;
    return std::all_of(pixels.begin(), pixels.end(), [](float value) { return value <= 0; });
}

void tell_result(const RenderReport& report, const Film& film, Console& console) {
    const RenderStatistics& s = report.statistics;
    if (!s.interrupted && is_black(film))
        console.warn(
            "the picture is black: nothing that the camera sees is lit; try another side (-a, -e, --eye), and "
            "`cardioid check`");
    if (s.bad_samples > 0)
        console.warn(fmt::format("{} samples were not finite or negative and count as black, the first in pixel {},{}",
                                 s.bad_samples, s.first_bad_pixel[0], s.first_bad_pixel[1]));
    if (console.verbose())
        for (const std::string& line : statistics_lines(report)) console.log(1, line);
    console.tell(fmt::format("{}: {}x{}, {} samples a pixel, {:.1f} s", report.options.output, report.settings.width,
                             report.settings.height, s.samples, s.seconds));
}

void warn_all(const std::vector<std::string>& warnings, Console& console) {
    for (const std::string& warning : warnings) console.warn(warning);
}

int render_scene(const RenderOptions& options, const std::string& command, Console& console) {
    Stopwatch watch;
    const std::unique_ptr<Registry> registry = open_registry(options.scene.plugins);
    console.begin("read");
    Scene scene = read_scene(options.scene, *registry);
    warn_all(scene.warnings, console);
    static_cast<void>(picture_size(options, scene));
    LightingChoice choice = choose_lighting(options, scene, *registry);
    keep_what_is_shown(options.view, choice);
    end_straight_shadows(scene, choice);
    warn_all(choice.warnings, console);
    const std::unique_ptr<LightingModule> module = make_lighting(choice, options.seed);
    watch.lap("read");

    console.begin("build");
    Box3d model;
    const CommittedScene committed(scene, *registry, measuring_compiler(model), {true, options.ground});
    warn_all(committed.warnings(), console);
    const RenderSettings settings = render_settings(options, scene, model, *module);
    leave_threads_asleep(options, settings, *choice.kind);
    check_image_formats();  // before the work whose picture would be lost
    watch.lap("build");

    catch_interrupts();  // until here there was nothing to save
    prepare_lighting(*module, options, committed, settings, console);
    watch.lap("prepare");
    if (interrupted()) throw Error(ErrorCode::interrupted, "interrupted before the first pixel; nothing is saved");
    const RenderResult result = render(committed, *module, settings, console);
    watch.lap("render");

    RenderReport report{options, scene, committed, *choice.kind, *module, settings, result.statistics, command};
    write_picture(report, result.film);
    watch.lap("write");
    if (!result.statistics.interrupted && (!options.stats.empty() || console.verbose())) {
        report.energy = energy_ledger(committed, options.seed);
        warn_all(ledger_warnings(*report.energy), console);
        watch.lap("ledger");
    }
    report.phases_s = watch.phases_s;
    if (!options.stats.empty()) write_text(options.stats, statistics_json(report));
    tell_result(report, result.film, console);
    if (!result.statistics.interrupted) return 0;
    throw Error(ErrorCode::interrupted, fmt::format("interrupted; {} has what was drawn so far", options.output));
}

}  // namespace

int run_render(const std::vector<std::string>& words) {
    const std::optional<RenderOptions> options = parse_render_options(words);
    if (!options) return 0;
    check_outputs(*options);
    if (options->threads > 0) omp_set_num_threads(options->threads);
    Console console(options->loudness(), progress_style(options->progress, options->loudness()));
    return render_scene(*options, recorded_command(words), console);
}

}  // namespace cardioid::cli

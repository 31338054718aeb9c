#include "cli/options/probe_options.hpp"

#include "cli/options/values.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::cli {
namespace {

const std::string fallback_lighting = "path";
constexpr double fallback_noise = 0.01;
/// Fewer tell too little about their own noise.
constexpr int fewest_samples = 16, most_samples = 1 << 24;

constexpr const char* examples =
    "Each line of the points is x y z nx ny nz: a place, and where the lit side of a small plate there looks (or, for\n"
    "radiance, where the eye looks). Each gives a line R G B seR seG seB: irradiance [W/unit^2] on that side "
    "(radiance\n"
    "[W/(sr unit^2)]) and its standard errors. Empty lines and comments (#) give none. A plate within 1e-5 of a\n"
    "surface is on it. A scene without light is dark here: there is no studio.\n\n"
    "Examples:\n"
    "  echo 0 0 0.8 0 0 1 | cardioid probe room.csg --points -        on a table, by path tracing, to 1 %\n"
    "  cardioid probe room.csg --points grid.txt --noise 0.1% -o lux.txt --json lux.json\n"
    "  cardioid probe room.csg --points rays.txt --what radiance --photons\n";

void add_measure_options(Arguments& a, ProbeOptions& o) {
    a.group("What is measured");
    a.text("--points", "FILE", "Lines x y z nx ny nz; - is standard input", o.points);
    a.value("--what", "irradiance|radiance", "... on a plate, or along a ray [irradiance]",
            [&o](const std::string& text) {
                const std::vector<std::string> names{"irradiance", "radiance"};
                o.what = to_choice("--what", text, names) == "radiance" ? Quantity::radiance : Quantity::irradiance;
            });
    a.value("--noise", "SHARE", "Sample each point until its standard error is below this share of its luminance [1%]",
            [&o](const std::string& text) { o.noise = to_share("--noise", text); });
    a.value("--spp", "N", "Samples a point instead of --noise; with it, the most a point may take",
            [&o](const std::string& text) {
                o.samples = static_cast<std::uint32_t>(to_integer("--spp", text, fewest_samples, most_samples));
            });
    add_seed_options(a, o, "result");
    a.text("-o,--output", "FILE", "Where the lines go [standard output]", o.output);
    a.text("--json", "FILE", "The same and statistics as JSON; - is standard output, in place of the lines", o.json);
}

void check(const ProbeOptions& o) {
    check_run_options(o);
    if (o.points.empty()) throw Error(ErrorCode::usage, "--points is needed: a file of lines x y z nx ny nz, or -");
    exclude(o.points == "-", o.scene.file == "-", "SCENE - and --points -");
    exclude(o.json == "-", o.output == "-", "--json - and -o -");
    if (!o.json.empty() && o.json == o.output) throw Error(ErrorCode::usage, "--json and -o name the same file");
}

}  // namespace

ProbeSettings ProbeOptions::settings_for_probe() const {
    ProbeSettings probe;
    probe.what = what;
    probe.noise = noise > 0 ? noise : samples > 0 ? 0 : fallback_noise;
    probe.most_samples = samples;
    probe.seed = seed;
    return probe;
}

std::optional<ProbeOptions> parse_probe_options(const std::vector<std::string>& words) {
    ProbeOptions options;
    Arguments arguments("probe SCENE --points FILE [options]",
                        "Measures the light that arrives at given points, with its standard error.");
    add_measure_options(arguments, options);
    arguments.group("Light");
    add_lighting_options(arguments, options, fallback_lighting + ": unbiased");
    arguments.flag("--ground", "A ground plane under the model", options.ground);
    add_scene_options(arguments, options.scene);
    arguments.group("Messages");
    add_message_options(arguments, options);
    arguments.examples(examples);
    if (!arguments.parse(words)) return std::nullopt;
    take_format_options(options.scene, options.settings, nullptr);
    check(options);
    if (options.lighting.empty() && options.photons.empty()) options.lighting = fallback_lighting;
    if (options.output.empty() && options.json != "-") options.output = "-";
    return options;
}

}  // namespace cardioid::cli

#include "cli/options/render_options.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "cli/options/values.hpp"
#include "rt_core/api/error.hpp"
#include "rt_core/render/renderer.hpp"

namespace cardioid::cli {
namespace {

constexpr int most_samples = 1 << 24;

void add_picture_options(Arguments& a, RenderOptions& o) {
    a.group("Picture");
    a.text("-o,--output", "FILE", "Picture to write; its ending tells the format [SCENE's name, .png]", o.output);
    a.value("-s,--size", "WxH|N", "Size in pixels [the scene's, else 800x600]",
            [&](const std::string& text) { o.size = to_size("--size", text); });
    a.value("--crop", "x0,y0,x1,y1", "Draw only these pixels, from the top left, ends excluded",
            [&](const std::string& text) {
                std::array<int, 4> crop{};
                const auto v = to_numbers("--crop", text, 4, "four whole numbers x0,y0,x1,y1");
                for (std::size_t i = 0; i < 4; ++i) {
                    crop[i] = static_cast<int>(std::clamp(v[i], -1.0, 1e9));
                    if (crop[i] != v[i])
                        throw Error(ErrorCode::usage, fmt::format("--crop: found \"{}\", wanted pixels", text));
                }
                o.crop = crop;
            });
    a.value("--exposure", "EV", "Brighten an 8-bit picture by 2^EV [the scene's, else 0]",
            [&](const std::string& text) { o.exposure = to_number("--exposure", text, -100, 100); });
    a.value("--aov", "LIST", "Layers to write too: " + fmt::format("{}", fmt::join(layer_names(), ",")),
            [&](const std::string& text) {
                for (const std::string& word : to_list(text)) {
                    const std::string layer = to_choice("--aov", word, layer_names());
                    if (std::find(o.layers.begin(), o.layers.end(), layer) == o.layers.end()) o.layers.push_back(layer);
                }
            });
    a.text("--view", "NAME",
           fmt::format("Draw {} or a view of the lighting module instead; a FILE is a script of BRL-CAD's rt",
                       fmt::join(view_names(), ", ")),
           o.view);
    a.flag("--half", "OpenEXR in half precision", o.half);
}

void add_quality_options(Arguments& a, RenderOptions& o) {
    a.group("Quality");
    a.value("--quality", "draft|normal|high", "4, 32 or 256 samples a pixel [normal]", [&](const std::string& text) {
        const std::vector<std::string> names{"draft", "normal", "high"};
        const std::string name = to_choice("--quality", text, names);
        o.quality_samples = name == "draft" ? 4 : name == "normal" ? 32 : 256;
        if (!(o.noise > 0)) o.photon_error = name == "draft" ? 0.1 : name == "normal" ? 0.05 : 0.02;
    });
    a.value("--spp", "N", "Samples a pixel [the scene's, else --quality]",
            [&](const std::string& text) { o.samples = static_cast<int>(to_integer("--spp", text, 1, most_samples)); });
    a.value("--time", "TIME", "Sample for so long: 30s, 2m, 1.5h",
            [&](const std::string& text) { o.time_s = to_seconds("--time", text); });
    a.value("--noise", "SHARE", "Sample until the noise of the picture is below: 2%", [&](const std::string& text) {
        o.noise = to_share("--noise", text);
        // Hundreds of rays and several cache points average what a lookup scatters by.
        o.photon_error = std::clamp(5 * o.noise, 0.01, 0.3);
    });
    a.value("--filter", "box|gaussian",
            "What a pixel is the mean of: its square, or softer, a little around it too [box]",
            [&](const std::string& text) {
                const std::vector<std::string> names{"box", "gaussian"};
                o.gaussian_filter = to_choice("--filter", text, names) == "gaussian";
            });
    add_seed_options(a, o, "picture");
}

void add_camera_options(Arguments& a, RenderOptions& o) {
    a.group("Camera");
    a.text("--camera", "NAME", "A camera of the scene [its first]", o.camera);
    a.value("-a,--azimuth", "DEG", "See the whole model from this side [35 where the scene has no camera]",
            [&](const std::string& text) { o.azimuth_deg = to_number("--azimuth", text, -3600, 3600); });
    a.value("-e,--elevation", "DEG", "... and from this height [25]",
            [&](const std::string& text) { o.elevation_deg = to_number("--elevation", text, -90, 90); });
    a.value("--eye", "x,y,z", "Look from here", [&](const std::string& text) { o.eye = to_vector("--eye", text); });
    a.value("--target", "x,y,z", "... to here [the middle of the model]",
            [&](const std::string& text) { o.target = to_vector("--target", text); });
    a.value("--fov", "DEG", "Vertical angle of view [the camera's, else 40]",
            [&](const std::string& text) { o.fov_deg = to_number("--fov", text, 0.01, 179); });
}

void add_light_options(Arguments& a, RenderOptions& o) {
    a.group("Light");
    add_lighting_options(a, o, "direct");
    a.flag("--ground", "A ground plane under the model", o.ground);
}

void add_report_options(Arguments& a, RenderOptions& o) {
    a.group("Messages");
    a.text("--stats", "FILE", "Write times, counts, memory and where the light goes as JSON", o.stats);
    add_message_options(a, o);
}

void check(const RenderOptions& o) {
    const bool around = o.azimuth_deg || o.elevation_deg, placed = o.eye || o.target;
    exclude(!o.camera.empty(), around, "--camera and -a or -e");
    exclude(!o.camera.empty(), placed, "--camera and --eye or --target");
    exclude(around, placed, "-a or -e and --eye or --target");
    check_run_options(o);
    exclude(!o.view.empty(), !o.layers.empty(), "--view and --aov");
    if (!o.stats.empty() && o.stats == o.output) throw Error(ErrorCode::usage, "--stats and -o name the same file");
    if (!o.save_map.empty() && (o.save_map == o.output || o.save_map == o.stats))
        throw Error(ErrorCode::usage, "--save-map and -o or --stats name the same file");
    if (o.target && !o.eye) throw Error(ErrorCode::usage, "--target needs --eye");
}

constexpr const char* examples =
    "Examples:\n"
    "  cardioid part.csg                            part.png, 800x600, fitted camera and studio light\n"
    "  cardioid room.csg -s 1920x1080 --quality high -o room.exr --aov normal,depth\n"
    "  cardioid part.csg -a -30 -e 10 --ground      seen from the left, standing on a floor\n"
    "  cardioid room.csg --eye -1,2,3 --target 0,0,1 --fov 60 --time 30s\n";

}  // namespace

std::optional<RenderOptions> parse_render_options(const std::vector<std::string>& words) {
    RenderOptions options;
    Arguments arguments("[render] SCENE [options]", "Draws a scene.");
    add_picture_options(arguments, options);
    add_quality_options(arguments, options);
    add_camera_options(arguments, options);
    add_light_options(arguments, options);
    add_scene_options(arguments, options.scene);
    add_report_options(arguments, options);
    arguments.examples(examples);
    if (!arguments.parse(words)) return std::nullopt;
    take_format_options(options.scene, options.settings, &options.view);
    check(options);
    if (options.output.empty())
        options.output = options.scene.file == "-" ? "stdin.png"
                                                   : std::filesystem::path(options.scene.file).stem().string() + ".png";
    return options;
}

std::string recorded_command(const std::vector<std::string>& words) {
    static const std::vector<std::string> with_value{"-o",      "--output",   "-j",        "--threads",
                                                     "--stats", "--progress", "--save-map"};
    static const std::vector<std::string> flags{"-q", "--quiet", "-v", "--verbose"};
    const auto in = [](const std::vector<std::string>& list, const std::string& word) {
        return std::find(list.begin(), list.end(), word) != list.end();
    };
    std::string text = "cardioid render";
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const bool glued =
            in(with_value, word.substr(0, word.find('='))) || (word.size() > 2 && in(with_value, word.substr(0, 2)));
        if (in(with_value, word))
            ++i;
        else if (!glued && !in(flags, word))
            text += word.find_first_of(" \t\"'\\$*?;&|<>()") == std::string::npos ? " " + word : " '" + word + "'";
    }
    return text;
}

}  // namespace cardioid::cli

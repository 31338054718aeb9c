#include "cli/compare/compare_options.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/compare/limits_toml.hpp"
#include "cli/io/scene_input.hpp"
#include "cli/options/arguments.hpp"
#include "cli/options/values.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::cli {
namespace {

using Json = nlohmann::json;

constexpr double most = 1e30;

PictureRegion to_region(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string option = "--region";
    if (equals == std::string::npos || equals == 0)
        throw Error(ErrorCode::usage, fmt::format("{}: found \"{}\", wanted NAME=x0,y0,x1,y1", option, text));
    const auto xs = to_numbers(option, std::string_view(text).substr(equals + 1), 4, "NAME=x0,y0,x1,y1");
    const auto at = [&](std::size_t i) { return static_cast<int>(xs[i]); };
    return {text.substr(0, equals), at(0), at(1), at(2), at(3)};
}

/// What a file of limits says, on top of what is there.
class LimitsFile {
public:
    LimitsFile(const std::string& path, CompareOptions& options) : path_(path), options_(options) {
        const std::string text = read_text(path);
        try {
            json_ = path.ends_with(".toml") ? parse_limits_toml(path, text) : Json::parse(text);
        } catch (const Json::exception& error) {
            throw Error(ErrorCode::bad_input, fmt::format("{}: found no JSON: {}", path, error.what()));
        }
        if (!json_.is_object()) fail("found no object, wanted {\"limits\": {\"rmse\": 0.01}}");
    }

    void read() {
        for (const auto& [key, value] : json_.items()) {
            if (key == "limits")
                limits(value);
            else if (key == "regions")
                regions(value);
            else if (key == "tolerance")
                options_.settings.tolerance = number(key, value);
            else if (key == "exposure")
                options_.settings.exposure = number(key, value);
            else if (key == "grid")
                options_.grid = grid(value);
            else if (key == "skip-edges")
                options_.settings.skip_edges = truth(key, value);
            else if (key != "proves" && key != "scene")
                unknown(key, {"limits", "regions", "tolerance", "exposure", "grid", "skip-edges", "proves", "scene"});
        }
    }

private:
    [[noreturn]] void fail(const std::string& text) const { throw Error(ErrorCode::bad_input, path_ + ": " + text); }
    [[noreturn]] void unknown(const std::string& key, const std::vector<std::string>& known) const {
        fail(fmt::format("found \"{}\", wanted {}{}", key, either(known), suggestion(key, known)));
    }
    [[nodiscard]] double number(const std::string& key, const Json& value) const {
        if (!value.is_number()) fail(fmt::format("\"{}\" must be a number", key));
        return value.get<double>();
    }
    [[nodiscard]] int grid(const Json& value) const {
        const double n = number("grid", value);
        if (n != std::floor(n) || n < 1 || n > 64) fail("\"grid\" must be a whole number from 1 to 64");
        return static_cast<int>(n);
    }
    [[nodiscard]] bool truth(const std::string& key, const Json& value) const {
        if (!value.is_boolean()) fail(fmt::format("\"{}\" must be true or false", key));
        return value.get<bool>();
    }
    void limits(const Json& json) {
        if (!json.is_object()) fail("\"limits\" must be an object");
        std::vector<std::string> known;
        for (const LimitKind& kind : limit_kinds()) known.emplace_back(kind.name);
        for (const auto& [key, value] : json.items()) {
            if (std::find(known.begin(), known.end(), key) == known.end()) unknown(key, known);
            options_.limits[key] = number(key, value);
        }
    }
    void regions(const Json& json) {
        if (!json.is_object()) fail("\"regions\" must be an object");
        for (const auto& [name, box] : json.items()) {
            if (!box.is_array() || box.size() != 4) fail(fmt::format("region \"{}\" must be [x0, y0, x1, y1]", name));
            const auto at = [&](std::size_t i) { return static_cast<int>(number(name, box[i])); };
            options_.settings.regions.push_back({name, at(0), at(1), at(2), at(3)});
        }
    }

    std::string path_;
    CompareOptions& options_;
    Json json_;
};

void add_options(Arguments& arguments, CompareOptions& options, std::vector<std::string>& regions) {
    arguments.positional("A", "Picture to be judged", options.a);
    arguments.positional("B", "Reference", options.b);
    arguments.group("Limits; without any the pictures must be the same");
    for (const LimitKind& kind : limit_kinds()) {
        const std::string name = std::string("--max-") + kind.name;
        arguments.value(name, "X", kind.help, [&options, &kind, name](const std::string& text) {
            options.limits[kind.name] = text.ends_with('%') ? to_share(name, text) : to_number(name, text, 0, most);
        });
    }
    arguments.value(
        "--tolerance", "T", "Relative difference from which on a pixel is beyond [0.001]",
        [&](const std::string& text) { options.settings.tolerance = to_number("--tolerance", text, 0, most); });
    arguments.group("What is compared");
    arguments.list("--region", "NAME=x0,y0,x1,y1", "Figures of a part too; may be given again", regions);
    arguments.value("--grid", "N", "Figures of N x N parts too", [&](const std::string& text) {
        options.grid = static_cast<int>(to_integer("--grid", text, 1, 64));
    });
    arguments.flag("--skip-edges", "Leave out pixels at outlines, as layers normal, depth and region tell them",
                   options.settings.skip_edges);
    arguments.value(
        "--exposure", "EV", "How bright both are shown, for FLIP and the report [0]",
        [&](const std::string& text) { options.settings.exposure = to_number("--exposure", text, -100, 100); });
    arguments.group("Results");
    arguments.text("--report", "DIR", "A page to look at: DIR/index.html", options.report);
    arguments.text("--json", "FILE", "All figures as JSON; - is standard output", options.json);
    arguments.flag("-q,--quiet", "Print no figures", options.quiet);
    arguments.examples(
        "Examples:\n  cardioid compare new.exr old.exr --max-rmse 0.01 --max-bias 2% --report out\n"
        "  cardioid compare a.png b.png             the same to the last bit?\n\n"
        "Exit status: 0 equal within the limits, 1 not, 2 wrong usage, 3 bad file of limits, 4 cannot read or "
        "write.\n");
}

/// The file of limits is read first, so that the command line wins over it.
std::string limits_file(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--limits" && i + 1 < words.size()) return words[i + 1];
        if (words[i].starts_with("--limits=")) return words[i].substr(9);
    }
    return "";
}

}  // namespace

const std::vector<LimitKind>& limit_kinds() {
    static const std::vector<LimitKind> kinds{
        {"rmse", "Root of the mean squared difference", [](const RegionFigures& f) { return f.rmse; }, false},
        {"relmse", "Mean squared difference relative to the reference",
         [](const RegionFigures& f) { return f.relative_mse; }, false},
        {"bias", "Relative difference of the means, of the whole and every region; also as 2%",
         [](const RegionFigures& f) { return std::abs(f.bias); }, true},
        {"flip", "Mean LDR-FLIP, 0 to 1", [](const RegionFigures& f) { return f.flip; }, false},
        {"p999", "Difference that 99.9 % of the pixels stay within", [](const RegionFigures& f) { return f.p999; },
         false},
        {"difference", "Largest difference of a channel", [](const RegionFigures& f) { return f.max; }, false},
        {"beyond", "Share of pixels whose relative difference is above --tolerance; also as 0.1%",
         [](const RegionFigures& f) { return f.beyond; }, false},
        {"z", "Difference of means in standard errors, of the whole and every region, by layers variance",
         [](const RegionFigures& f) { return f.z ? std::abs(*f.z) : HUGE_VAL; }, true}};
    return kinds;
}

std::optional<CompareOptions> parse_compare_options(const std::vector<std::string>& words) {
    CompareOptions options;
    if (const std::string file = limits_file(words); !file.empty()) LimitsFile(file, options).read();
    Arguments arguments("compare A B [options]", "Tells by how much two pictures differ, and whether by too much.");
    std::vector<std::string> regions;
    add_options(arguments, options, regions);
    arguments.text("--limits", "FILE", "Read limits and settings from a .toml or JSON file; options win",
                   options.limits_file);
    if (!arguments.parse(words)) return std::nullopt;
    for (const std::string& region : regions) options.settings.regions.push_back(to_region(region));
    return options;
}

std::vector<PictureRegion> grid_regions(int n, int width, int height) {
    std::vector<PictureRegion> out;
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const PictureRegion region{fmt::format("row {}, column {}", row + 1, column + 1), width * column / n,
                                       height * row / n, width * (column + 1) / n, height * (row + 1) / n};
            if (region.x0 < region.x1 && region.y0 < region.y1) out.push_back(region);
        }
    return out;
}

}  // namespace cardioid::cli

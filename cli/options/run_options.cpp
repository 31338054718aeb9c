#include "cli/options/run_options.hpp"

#include <fmt/format.h>

#include "cli/options/values.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::cli {

void add_lighting_options(Arguments& a, RunOptions& o, const std::string& fallback) {
    a.text("--lighting", "NAME", fmt::format("How light travels; cardioid list lighting names them [{}]", fallback),
           o.lighting);
    a.optional_value("--photons", "Short for --lighting photon; --photons=COUNT sets how many, as 1e6 or 2.5M",
                     o.photons);
    a.flag("--no-photons", "Without photons, whatever the scene says", o.no_photons);
    a.list("--set", "module.option=value", "An option of a lighting module or format; cardioid list options names them",
           o.settings);
    a.text("--save-map", "FILE", "Keep what the lighting module has made", o.save_map);
    a.text("--load-map", "FILE", "... and use it again", o.load_map);
}

void add_seed_options(Arguments& a, RunOptions& o, const std::string& result) {
    a.value("--seed", "N", "Another N, other noise [0]", [&o](const std::string& text) {
        o.seed = static_cast<std::uint32_t>(to_integer("--seed", text, 0, 0xFFFFFFFFLL));
    });
    a.value("-j,--threads", "N", fmt::format("Threads [all processors]; the {} is the same for any number", result),
            [&o](const std::string& text) { o.threads = static_cast<int>(to_integer("--threads", text, 1, 4096)); });
}

void add_message_options(Arguments& a, RunOptions& o) {
    a.value("--progress", "auto|bar|lines|none", "How progress is shown [auto: a bar on a terminal, else lines]",
            [&o](const std::string& text) {
                const std::vector<std::string> names{"auto", "bar", "lines", "none"};
                o.progress = to_choice("--progress", text, names);
            });
    a.flag("-q,--quiet", "Nothing but errors", o.quiet);
    a.flag("-v,--verbose", "Tell what is done", o.verbose);
}

void exclude(bool a, bool b, std::string_view names) {
    if (a && b) throw Error(ErrorCode::usage, fmt::format("{} cannot be given together", names));
}

void check_run_options(const RunOptions& o) {
    exclude(!o.photons.empty(), o.no_photons, "--photons and --no-photons");
    exclude(!o.photons.empty(), !o.lighting.empty() && o.lighting != "photon", "--photons and another --lighting");
    exclude(o.no_photons, o.lighting == "photon", "--no-photons and --lighting photon");
    exclude(o.quiet, o.verbose, "-q and -v");
    exclude(!o.save_map.empty(), !o.load_map.empty(), "--save-map and --load-map");
    if (!o.photons.empty() && o.photons != "true") to_count("--photons", o.photons);
}

}  // namespace cardioid::cli

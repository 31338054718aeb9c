#include <algorithm>
#include <iterator>

#include "cli/builtins.hpp"
#include "cli/check/find_faults.hpp"
#include "cli/commands/commands.hpp"
#include "cli/io/scene_input.hpp"
#include "cli/io/text_output.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::cli {
namespace {

Findings look_for_all(const Scene& scene, const std::string& text, const Registry& registry) {
    Findings findings;
    find_reader_faults(scene, findings);
    find_unknown_colours(scene, text, findings);
    find_open_meshes(scene, findings);
    if (const auto committed = commit(scene, registry, findings)) {
        find_light_and_camera_faults(scene, *committed, registry, findings);
        find_overlaps(scene, *committed, is_one_union(scene, text), findings);
        find_near_faces(scene, findings);
    }
    return findings;
}

}  // namespace

int run_check(const std::vector<std::string>& words) {
    SceneOptions options;
    std::string json;
    bool strict = false;
    Arguments arguments("check SCENE [options]",
                        "Looks for overlapping solids, slivers, open meshes, lights without power, cameras inside "
                        "solids or without light, unknown materials and colours, solids of no size. Exit status 1 "
                        "where there are any.");
    arguments.text("--json", "FILE", "Write what is found as JSON; - is standard output, in place of the text", json);
    arguments.flag(
        "--strict",
        "Coincident faces and overlaps within one union, which are drawn right and otherwise only noted, are "
        "faults, too",
        strict);
    add_scene_options(arguments, options);
    add_format_settings(arguments, options);
    if (!arguments.parse(words)) return 0;
    if (!json.empty()) keep_scene(options, json, "--json"), check_text_path(json);

    const std::unique_ptr<Registry> registry = open_registry(options.plugins);
    options.unknown_is_warning = true;
    const std::string text = read_text(options.file);
    const Scene scene = read_scene(options, text, *registry);
    Findings findings = look_for_all(scene, text, *registry);
    if (strict) {
        const auto counts = [](const Finding& f) { return f.kind == "overlap" || f.kind == "coincident"; };
        std::copy_if(findings.notes.begin(), findings.notes.end(), std::back_inserter(findings.faults), counts);
        std::erase_if(findings.notes, counts);
    }
    if (json != "-") print_text(findings_text(scene, findings));
    if (!json.empty()) write_text(json, findings_json(scene, findings));
    return findings.faults.empty() ? 0 : static_cast<int>(ErrorCode::unequal);
}

}  // namespace cardioid::cli

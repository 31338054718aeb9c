#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/builtins.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/find_faults.hpp"
#include "cli/io/scene_input.hpp"
#include "cli/io/text_output.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::cli {
namespace {

constexpr std::size_t most_told = 100;  ///< faults that are printed

std::string findings_json(const Scene& scene, const Findings& findings) {
    using Json = nlohmann::ordered_json;
    Json faults = Json::array();
    for (const Fault& fault : findings.faults) faults.push_back({{"kind", fault.kind}, {"text", fault.text}});
    const Json json{{"file", scene.file}, {"faults", faults}, {"notes", findings.notes}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string findings_text(const Scene& scene, const Findings& findings) {
    std::string text;
    const std::size_t count = findings.faults.size(), told = std::min(count, most_told);
    for (std::size_t i = 0; i < told; ++i) text += findings.faults[i].text + "\n";
    if (told < count) text += fmt::format("... and {} more; --json has them all\n", count - told);
    for (const std::string& note : findings.notes) text += fmt::format("{}\n", note);
    return text + (count == 0   ? fmt::format("{}: no faults\n", scene.file)
                   : count == 1 ? fmt::format("{}: 1 fault\n", scene.file)
                                : fmt::format("{}: {} faults\n", scene.file, count));
}

}  // namespace

int run_check(const std::vector<std::string>& words) {
    SceneOptions options;
    std::string json;
    Arguments arguments("check SCENE [options]",
                        "Looks for overlapping solids, open meshes, lights without power, cameras inside solids, "
                        "unknown materials, solids of no size. Exit status 1 where there are any.");
    arguments.text("--json", "FILE", "Write what is found as JSON; - is standard output, in place of the text", json);
    add_scene_options(arguments, options);
    if (!arguments.parse(words)) return 0;
    if (!json.empty()) check_text_path(json);

    const std::unique_ptr<Registry> registry = open_registry(options.plugins);
    options.unknown_is_warning = true;
    const Scene scene = read_scene(options, *registry);
    Findings findings;
    find_reader_faults(scene, findings);
    find_open_meshes(scene, findings);
    if (const auto committed = commit(scene, *registry, findings)) {
        find_light_and_camera_faults(scene, *committed, findings);
        find_overlaps(scene, *committed, findings);
    }
    if (json != "-") print_text(findings_text(scene, findings));
    if (!json.empty()) write_text(json, findings_json(scene, findings));
    return findings.faults.empty() ? 0 : static_cast<int>(ErrorCode::unequal);
}

}  // namespace cardioid::cli

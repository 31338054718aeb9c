#include "cli/check/findings.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

namespace cardioid::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_notes = 5;  ///< of one kind that are told

Json to_json(const std::vector<Finding>& findings) {
    Json list = Json::array();
    for (const Finding& finding : findings) {
        Json item{{"kind", finding.kind}, {"text", finding.text}};
        if (finding.at) item["at"] = {finding.at->x, finding.at->y, finding.at->z};
        if (finding.depth) item["depth"] = *finding.depth;
        if (finding.volume) item["volume"] = *finding.volume;
        if (!finding.between.empty()) item["between"] = finding.between;
        list.push_back(std::move(item));
    }
    return list;
}

const char* reason(const std::string& kind) {
    return kind == "overlap"      ? "no fault: the top of an OpenSCAD file is one union"
           : kind == "coincident" ? "no fault: booleans are regularised, as in OpenSCAD's F6"
                                  : "no fault";
}

/// The first few of each kind, the rest as a number.
std::string notes_text(const std::vector<Finding>& notes) {
    std::map<std::string, std::size_t> told;
    std::string text;
    for (const Finding& note : notes)
        if (++told[note.kind] <= most_notes) text += "note: " + note.text + "\n";
    for (const auto& [kind, count] : told)
        if (kind == "overlap" || kind == "coincident")
            text += fmt::format("note: {} {}{} in all ({})\n", count, kind == "overlap" ? "overlap" : "coincident face",
                                count == 1 ? "" : "s", reason(kind));
        else if (count > most_notes)
            text += fmt::format("note: ... and {} more such notes; --json has them all\n", count - most_notes);
    return text;
}

}  // namespace

std::string findings_text(const Scene& scene, const Findings& findings, std::size_t most) {
    std::string text;
    const std::size_t count = findings.faults.size(), told = std::min(count, most);
    for (std::size_t i = 0; i < told; ++i) text += findings.faults[i].text + "\n";
    if (told < count) text += fmt::format("... and {} more; --json has them all\n", count - told);
    text += notes_text(findings.notes);
    return text + (count == 0   ? fmt::format("{}: no faults\n", scene.file)
                   : count == 1 ? fmt::format("{}: 1 fault\n", scene.file)
                                : fmt::format("{}: {} faults\n", scene.file, count));
}

std::string findings_json(const Scene& scene, const Findings& findings) {
    const Json json{{"file", scene.file},
                    {"faults", to_json(findings.faults)},
                    {"notes", to_json(findings.notes)},
                    {"grids",
                     {{"overlaps_lines_a_pair_and_axis", {16, 16}},
                      {"faces_lines_an_axis", {findings.face_grid, findings.face_grid}}}}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cardioid::cli

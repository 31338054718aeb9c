#include "cli/commands/describe_map.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>

#include "photon/file/map_reader.hpp"

namespace cardioid::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Lines "option = value" as an object.
Json options_json(const std::string& text) {
    Json json = Json::object();
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t equals = line.find(" = ");
        if (equals != std::string::npos) json[line.substr(0, equals)] = line.substr(equals + 3);
    }
    return json;
}

}  // namespace

Json map_json(const std::string& file) {
    const photon::MapReader reader(file);
    Json sections = Json::array();
    for (const photon::MapReader::Entry& entry : reader.entries())
        sections.push_back({{"name", entry.name}, {"count", entry.count}, {"bytes", entry.bytes}});
    return {{"file", file},
            {"scene", fmt::format("{:016x}", reader.scene())},
            {"sections", sections},
            {"options", reader.has("options") ? options_json(reader.text("options")) : Json::object()}};
}

std::string map_text(const Json& json) {
    std::string text =
        fmt::format("{}\nphoton map of scene {}\n", json["file"].get<std::string>(), json["scene"].get<std::string>());
    for (const Json& s : json["sections"])
        text += fmt::format("section {}: {} items, {} bytes\n", s["name"].get<std::string>(),
                            s["count"].get<std::uint64_t>(), s["bytes"].get<std::uint64_t>());
    for (const auto& [name, value] : json["options"].items())
        text += fmt::format("{} = {}\n", name, value.get<std::string>());
    return text;
}

}  // namespace cardioid::cli

#include "tests/accuracy/table.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

#include "rt_core/api/error.hpp"

namespace cardioid::test {

namespace {

using Json = nlohmann::json;
using Kind = Place::Kind;

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

Vec3d vector(const Json& json) { return {json.at(0), json.at(1), json.at(2)}; }

Place read_place(const Json& value, const std::string& what) {
    Place place;
    place.what = what == "radiance" ? Quantity::radiance : Quantity::irradiance;
    if (value.contains("along")) place.along = vector(value.at("along"));
    if (value.contains("eye")) place.along = vector(value.at("eye"));
    if (value.contains("point")) {
        place.origin = vector(value.at("point"));
    } else if (value.contains("rectangle")) {
        place.kind = value.contains("eye") ? Kind::view : Kind::rectangle;
        const Json& corners = value.at("rectangle");
        place.origin = vector(corners.at(0)), place.u = vector(corners.at(1)), place.v = vector(corners.at(2));
    } else if (value.contains("room")) {
        place.kind = Kind::room;
        place.origin = vector(value.at("room").at(0)), place.u = vector(value.at("room").at(1));
    } else {
        place.kind = value.contains("disc") ? Kind::disc : Kind::sphere;
        place.origin = vector(value.at(value.contains("disc") ? "disc" : "sphere"));
        place.radius = value.at("radius");
        place.side = value.value("side", 1.0);
    }
    return place;
}

std::map<std::string, double> read_tolerances(const Json& json) {
    if (json.is_number()) return {{"", json.get<double>()}};
    return json.get<std::map<std::string, double>>();
}

KnownValue read_value(const Json& group, const Json& value) {
    KnownValue read;
    read.section = group.at("section");
    read.scene = group.at("scene");
    read.source = group.at("source");
    read.name = value.at("name");
    const Json change = value.value("change", Json::object());
    for (const auto& [from, to] : change.items()) read.change.emplace_back(from, to);
    read.place = read_place(value, group.at("what"));
    read.expected = value.at("expected");
    read.tolerances = read_tolerances(value.contains("tolerance") ? value.at("tolerance") : group.at("tolerance"));
    read.formula = value.at("formula");
    read.args = value.at("args").get<std::vector<double>>();
    read.times = value.value("times", 1.0);
    read.modules = value.value("modules", group.value("modules", std::vector<std::string>{}));
    read.heavy = value.value("long", false);
    read.also = value.value("short", std::vector<std::string>{});
    return read;
}

std::vector<KnownValue> read_table() {
    const std::string file = CARDIOID_SOURCE_DIR "/samples/accuracy/expected.json";
    std::ifstream stream(file);
    if (!stream) throw Error(ErrorCode::io, file + ": cannot be read");
    std::vector<KnownValue> all;
    std::string at = "the beginning";
    try {
        const Json table = Json::parse(stream);
        for (const Json& group : table.at("groups"))
            for (const Json& value : group.at("values")) {
                all.push_back(read_value(group, value));
                at = all.back().title();
            }
    } catch (const Json::exception& error) {
        throw Error(ErrorCode::bad_input, fmt::format("{}: after {}: {}", file, at, error.what()));
    }
    return all;
}

}  // namespace

bool KnownValue::applies_to(const std::string& module) const { return modules.empty() || has(modules, module); }

bool KnownValue::in_short_run(const std::string& module) const {
    return applies_to(module) && (module == "path" ? !heavy : has(also, module));
}

bool KnownValue::same_setting(const KnownValue& other) const {
    return section == other.section && scene == other.scene && place.what == other.place.what && change == other.change;
}

double KnownValue::tolerance(const std::string& module) const {
    const auto own = tolerances.find(module);
    return own != tolerances.end() ? own->second : tolerances.at("");
}

std::string KnownValue::title() const { return fmt::format("{}: {}, {}", section, scene, name); }

const std::vector<KnownValue>& known_values() {
    static const std::vector<KnownValue> all = read_table();
    return all;
}

std::vector<Setting> known_settings(const std::string& module, Run run) {
    std::vector<Setting> settings;
    for (const KnownValue& value : known_values()) {
        if (run == Run::quick ? !value.in_short_run(module) : !value.applies_to(module)) continue;
        const auto same = std::find_if(settings.begin(), settings.end(),
                                       [&](const Setting& setting) { return setting.front().same_setting(value); });
        if (same == settings.end())
            settings.push_back({value});
        else
            same->push_back(value);
    }
    return settings;
}

std::string plain_name(const std::string& title) {
    std::string name;
    for (const char c : title) {
        const bool kept = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (kept)
            name += c;
        else if (c == '.')
            name += 'p';
        else if (c == '-')
            name += 'm';
        else if (!name.empty() && name.back() != '_')
            name += '_';
    }
    return name;
}

}  // namespace cardioid::test

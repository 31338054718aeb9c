#include "formats/brlcad/database.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

namespace cardioid::formats::brlcad {

namespace {

/// Up to four whole numbers in a text, whatever stands between them.
std::vector<long> whole_numbers(const std::string& text) {
    std::vector<long> out;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at < end) {
        long value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error == std::errc{}) out.push_back(value);
        at = error == std::errc{} ? next : at + 1;
    }
    return out;
}

std::optional<Colour8> colour_of(const std::vector<long>& numbers, std::size_t from) {
    if (numbers.size() < from + 3) return std::nullopt;
    Colour8 out{};
    for (std::size_t i = 0; i < 3; ++i) {
        const long c = numbers[from + i];
        out[i] = static_cast<std::uint8_t>(c < 0 ? 0 : c > 255 ? 255 : c);
    }
    return out;
}

int first_whole(const std::string& text) {
    const auto numbers = whole_numbers(text);
    if (numbers.empty()) return 0;
    return static_cast<int>(std::min(std::max(numbers[0], -2147483647L), 2147483647L));
}

bool says_yes(const std::string& text) {
    return !text.empty() && (text[0] == 'R' || text[0] == 'Y' || text[0] == 'y' || text[0] == 'r' || text[0] == '1');
}

}  // namespace

void Database::add(Object object) {
    const auto [place, fresh] = index.emplace(object.name, objects.size());
    if (fresh)
        objects.push_back(std::move(object));
    else
        objects[place->second] = std::move(object);
}

const Object* Database::find(const std::string& name) const {
    const auto found = index.find(name);
    return found == index.end() ? nullptr : &objects[found->second];
}

void set_attribute(Combination& combination, const std::string& key, const std::string& value) {
    if (key == "region")
        combination.region = says_yes(value);
    else if (key == "region_id" || key == "id")
        combination.region_id = first_whole(value);
    else if (key == "aircode" || key == "air")
        combination.air_code = first_whole(value);
    else if (key == "inherit")
        combination.inherit = says_yes(value);
    else if (key == "color" || (key == "rgb" && !combination.standard_colour))
        combination.colour = colour_of(whole_numbers(value), 0), combination.standard_colour = key == "color";
    else if (key == "oshader" || (key == "shader" && !combination.standard_shader))
        combination.shader = value, combination.standard_shader = key == "oshader";
}

void set_global(Database& database, const std::string& key, const std::string& value) {
    if (key == "title") database.title = value;
    if (key == "units") database.unit_mm = unit_mm(value);
    if (key != "regionid_colortable") return;
    const std::vector<long> numbers = whole_numbers(value);
    for (std::size_t i = 0; i + 5 <= numbers.size(); i += 5)
        database.colours.push_back({numbers[i], numbers[i + 1], *colour_of(numbers, i + 2)});
}

bool well_formed(const std::vector<Step>& steps) {
    std::size_t values = 0;
    for (const Step& step : steps) {
        const std::size_t taken = step.op == Step::Op::member ? 0 : step.op == Step::Op::complement ? 1 : 2;
        if (values < taken) return false;
        values = values - taken + 1;
    }
    return values == 1;
}

namespace {

struct Unit {
    const char* name;
    double mm;
};
constexpr Unit units[] = {{"um", 1e-3}, {"mm", 1},     {"cm", 10},    {"m", 1000},    {"km", 1e6},
                          {"in", 25.4}, {"ft", 304.8}, {"yd", 914.4}, {"mi", 1609344}};

}  // namespace

double unit_mm(const std::string& unit) {
    for (const Unit& known : units)
        if (unit == known.name) return known.mm;
    const double value = std::strtod(unit.c_str(), nullptr);
    return value > 0 ? value : 1;
}

std::string unit_name(double mm) {
    for (const Unit& known : units)
        if (std::abs(mm - known.mm) <= 1e-9 * known.mm) return known.name;
    return fmt::format("{:.6g} mm", mm);
}

}  // namespace cardioid::formats::brlcad

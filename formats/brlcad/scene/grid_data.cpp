#include "formats/brlcad/scene/grid_data.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

namespace cardioid::formats::brlcad {

namespace {

constexpr double most_count = 1 << 20;
/// Of one grid: more would be no grid of a model, and less than this fits into memory as triangles.
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 28;

/// The numbers of a text; nothing where something else is in it.
std::optional<std::vector<double>> numbers_in(const std::string& text) {
    std::vector<double> out;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        while (at < end && (*at == ' ' || *at == ',' || *at == '{' || *at == '}' || *at == '\t')) ++at;
        if (at == end) return out;
        double value = 0;
        const auto [next, error] = std::from_chars(*at == '+' ? at + 1 : at, end, value);
        if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
        out.push_back(value);
        at = next;
    }
}

}  // namespace

void GridFields::fail(const std::string& note) {
    if (good_) target_.note = note + ", and is left out";
    good_ = false;
}

std::string GridFields::text(const char* key, const std::string& fallback) const {
    const auto found = solid_.fields.find(key);
    return found == solid_.fields.end() ? fallback : found->second;
}

std::vector<double> GridFields::numbers(const char* key, std::vector<double> fallback) {
    const auto found = solid_.fields.find(key);
    if (found == solid_.fields.end()) return fallback;
    const auto values = numbers_in(found->second);
    if (values && values->size() == fallback.size()) return *values;
    fail(fmt::format("has \"{}\" for {}, wanted {} numbers", found->second.substr(0, 40), key, fallback.size()));
    return fallback;
}

double GridFields::number(const char* key, double fallback) { return numbers(key, {fallback})[0]; }

std::size_t GridFields::count(const char* key) {
    const double value = number(key, 0);
    if (value >= 1 && value <= most_count && value == std::floor(value)) return static_cast<std::size_t>(value);
    fail(fmt::format("has {} for {}, wanted a whole number from 1 to {}", value, key, most_count));
    return 1;
}

Affine GridFields::map(const char* key) {
    const std::vector<double> m = numbers(key, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    if (m[15] == 0 || m[12] != 0 || m[13] != 0 || m[14] != 0) {
        fail(fmt::format("has a matrix {} that is no map of solids", key));
        return {};
    }
    const double f = 1 / m[15];
    return {{Vec3d{m[0], m[1], m[2]} * f, Vec3d{m[4], m[5], m[6]} * f, Vec3d{m[8], m[9], m[10]} * f},
            Vec3d{m[3], m[7], m[11]} * f};
}

std::string GridFields::file(const std::string& name, std::uint64_t wanted) {
    const std::filesystem::path path = std::filesystem::path(target_.database->folder) / name;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        fail(fmt::format("is of file \"{}\", which is not there", path.string()));
        return {};
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || size < wanted) {
        fail(fmt::format("is of file \"{}\", which has {} bytes, wanted {}", path.string(), error ? 0 : size, wanted));
        return {};
    }
    std::string out(static_cast<std::size_t>(wanted), '\0');
    std::ifstream in(path, std::ios::binary);
    if (in.read(out.data(), static_cast<std::streamsize>(wanted))) return out;
    fail(fmt::format("is of file \"{}\", which cannot be read", path.string()));
    return {};
}

std::string GridFields::bytes(const char* key, bool of_object, std::uint64_t wanted,
                              std::initializer_list<int> elements) {
    const std::string name = text(key);
    if (good_ && wanted > most_bytes)
        fail(fmt::format("has a grid of {} bytes, wanted at most {}", wanted, most_bytes));
    if (good_ && (name.empty() || !target_.database)) fail("names no data");
    if (!good_) return {};
    if (!of_object) return file(name, wanted);
    const Object* object = target_.database->find(name);
    if (!object || object->combination || object->solid.kind != SolidKind::data)
        fail(fmt::format("is of object \"{}\", which {}", name, object ? "holds no numbers" : "is not there"));
    else if (std::find(elements.begin(), elements.end(), object->solid.element) == elements.end())
        fail(fmt::format("is of object \"{}\", whose numbers are of type {}, wanted {}", name, object->solid.element,
                         *elements.begin()));
    else if (object->solid.bytes.size() < wanted)
        fail(fmt::format("is of object \"{}\", which has {} bytes, wanted {}", name, object->solid.bytes.size(),
                         wanted));
    else
        return object->solid.bytes.substr(0, static_cast<std::size_t>(wanted));
    return {};
}

}  // namespace cardioid::formats::brlcad

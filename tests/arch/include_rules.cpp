#include "tests/arch/include_rules.hpp"

#include <algorithm>
#include <span>
#include <string_view>

namespace cardioid::test {

namespace {

/// What the sources under `room` may include besides the room itself. Folders end in '/', the rest are single headers.
struct Room {
    std::string_view room;
    std::vector<std::string_view> may_include;
};

/// Deeper rooms stand before those around them: the first that fits a path counts.
const std::vector<Room>& rooms() {
    static const std::vector<Room> all{
        {"rt_core/math/", {}},
        {"rt_core/api/", {"rt_core/math/"}},
        {"rt_core/scene/", {"rt_core/api/", "rt_core/math/"}},
        {"rt_core/trace/", {"rt_core/api/", "rt_core/math/", "rt_core/scene/"}},
        {"rt_core/image/", {"rt_core/api/", "rt_core/math/", "rt_core/scene/nearest_name.hpp"}},
        {"rt_core/plugin/", {"rt_core/api/", "rt_core/scene/nearest_name.hpp"}},
        {"rt_core/render/", {"rt_core/api/", "rt_core/math/", "rt_core/scene/", "rt_core/trace/", "rt_core/image/"}},
        {"csg/",
         {"rt_core/api/", "rt_core/math/", "rt_core/scene/", "rt_core/trace/region.hpp", "rt_core/trace/geometry.hpp"}},
        {"shaders/", {"rt_core/api/"}},
        {"photon/", {"rt_core/api/"}},
        {"samples/", {"rt_core/api/"}},
        {"formats/", {"rt_core/", "csg/"}},
        {"cli/", {"rt_core/", "csg/", "shaders/", "photon/", "formats/"}},
        {"bench/", {"rt_core/", "csg/", "shaders/", "photon/", "formats/", "cli/"}},
        {"tests/", {"rt_core/", "csg/", "shaders/", "photon/", "formats/", "cli/"}},
    };
    return all;
}

/// Libraries that one room of the product wraps for all others.
struct Library {
    std::string_view header;  ///< how its headers begin
    std::vector<std::string_view> users;
};

const std::vector<Library>& libraries() {
    static const std::vector<Library> all{
        {"embree", {"rt_core/trace/embree.hpp"}},
        {"OpenImageIO/", {"rt_core/image/openimageio_module.cpp"}},
        {"CGAL/", {"csg/"}},
        {"polyclipping/", {"csg/"}},
        {"CLI/", {"cli/"}},
        {"nlohmann/", {"cli/", "formats/mesh/"}},
    };
    return all;
}

bool begins_with_one_of(std::string_view path, std::span<const std::string_view> prefixes) {
    return std::ranges::any_of(prefixes, [&](std::string_view prefix) { return path.starts_with(prefix); });
}

/// The complaint about a quoted include, or "".
std::string quoted_complaint(const Source& source, const std::string& path) {
    if (("/" + path).find("/../") != std::string::npos) return "\"" + path + "\" goes up; write it from the top";
    // A test may name a helper that stands beside it without the folder.
    if (source.path.starts_with("tests/") && path.find('/') == std::string::npos) return "";
    const auto room = std::ranges::find_if(rooms(), [&](const Room& r) { return source.path.starts_with(r.room); });
    if (room == rooms().end()) return "no rule says what this folder may include";
    if (path.starts_with(room->room) || begins_with_one_of(path, room->may_include)) return "";
    return std::string(room->room) + " may not include \"" + path + "\"";
}

/// The complaint about an include in angle brackets, or "". Tests and benchmarks may use every library.
std::string library_complaint(const Source& source, const std::string& path) {
    if (source.path.starts_with("tests/") || source.path.starts_with("bench/")) return "";
    for (const Library& library : libraries())
        if (path.starts_with(library.header) && !begins_with_one_of(source.path, library.users))
            return "<" + path + "> belongs to " + std::string(library.users.front()) + " alone";
    for (const Room& room : rooms())
        if (path.starts_with(room.room)) return "<" + path + "> is our own; write it in quotes";
    return "";
}

}  // namespace

std::vector<std::string> include_complaints(const Source& source) {
    std::vector<std::string> complaints;
    for (const Include& include : source.includes) {
        const std::string complaint =
            include.quoted ? quoted_complaint(source, include.path) : library_complaint(source, include.path);
        if (!complaint.empty())
            complaints.push_back(source.path + ":" + std::to_string(include.line) + ": " + complaint);
    }
    return complaints;
}

std::vector<std::string> file_complaints(const Source& source) {
    constexpr std::size_t most_lines = 400;
    std::vector<std::string> complaints;
    const bool header = source.path.ends_with(".hpp") || source.path.ends_with(".h");
    if (header && !source.guarded) complaints.push_back(source.path + ":1: a header without #pragma once");
    if (source.lines > most_lines && !source.path.ends_with("_table.cpp"))
        complaints.push_back(source.path + ":" + std::to_string(source.lines) + ": more than 400 lines");
    return complaints;
}

}  // namespace cardioid::test

#include "formats/povray/scene/sdl.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <numbers>

namespace cardioid::formats::povray {

std::string sdl(double x) { return fmt::format("{:.15g}", x + 0.0); }

std::string sdl(Vec3d v) { return fmt::format("<{}, {}, {}>", sdl(v.x), sdl(v.y), sdl(v.z)); }

std::string sdl(Rgb c) {
    if (c.r == c.g && c.g == c.b) return fmt::format("rgb {:.9g}", c.r);
    return fmt::format("rgb <{:.9g}, {:.9g}, {:.9g}>", c.r, c.g, c.b);
}

std::string sdl_over_pi(Rgb c, double times) {
    const auto channel = [&](float x) { return static_cast<float>(double{x} * times * std::numbers::inv_pi); };
    return sdl(Rgb{channel(c.r), channel(c.g), channel(c.b)});
}

std::string sdl(const Affine& map) {
    std::string text = "matrix <";
    for (int i = 0; i < 3; ++i) {
        const Vec3d c = map.column(i);
        text += fmt::format("{}, {}, {}, ", sdl(c.x), sdl(c.y), sdl(c.z));
    }
    return text + fmt::format("{}, {}, {}>", sdl(map.t.x), sdl(map.t.y), sdl(map.t.z));
}

std::string Identifiers::make(std::string_view prefix, std::string_view name) {
    std::string id(prefix);
    for (const char c : name.substr(0, 30)) id += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    const std::string plain = id;
    for (int i = 2; std::find(taken_.begin(), taken_.end(), id) != taken_.end(); ++i)
        id = fmt::format("{}_{}", plain, i);
    taken_.push_back(id);
    return id;
}

void Notes::add(const std::string& where, const std::string& text) {
    std::string note = where.empty() ? text : where + ": " + text;
    if (std::find(all_.begin(), all_.end(), note) == all_.end()) all_.push_back(std::move(note));
}

}  // namespace cardioid::formats::povray

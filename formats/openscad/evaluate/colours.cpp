#include "formats/openscad/evaluate/colours.hpp"

#include <algorithm>
#include <cmath>

#include "formats/openscad/evaluate/colour_table.hpp"
#include "rt_core/scene/nearest_name.hpp"

namespace cardioid::formats::openscad {
namespace {

constexpr Rgba from_24_bits(std::uint32_t rgb) {
    return {static_cast<double>(rgb >> 16U) / 255, static_cast<double>((rgb >> 8U) & 255U) / 255,
            static_cast<double>(rgb & 255U) / 255, 1};
}

int hex_digit(char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

std::optional<Rgba> parse_hex(std::string_view digits) {
    if (digits.size() != 3 && digits.size() != 4 && digits.size() != 6 && digits.size() != 8) return std::nullopt;
    const std::size_t width = digits.size() > 4 ? 2 : 1;
    Rgba out{0, 0, 0, 1};
    for (std::size_t i = 0; i * width < digits.size(); ++i) {
        const int high = hex_digit(digits[i * width]), low = hex_digit(digits[i * width + width - 1]);
        if (high < 0 || low < 0) return std::nullopt;
        out[i] = (16 * high + low) / 255.0;
    }
    return out;
}

float linear(double display) {
    return static_cast<float>(display <= 0.04045 ? display / 12.92 : std::pow((display + 0.055) / 1.055, 2.4));
}

}  // namespace

std::optional<Rgba> parse_colour(std::string_view text) {
    if (text.starts_with('#')) return parse_hex(text.substr(1));
    std::string name(text);
    for (char& c : name)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (name == "transparent") return Rgba{0, 0, 0, 0};
    for (const NamedColour& colour : colour_table())
        if (name == colour.name) return from_24_bits(colour.rgb);
    return std::nullopt;
}

std::span<const std::string_view> colour_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> out;
        for (const NamedColour& colour : colour_table()) out.emplace_back(colour.name);
        return out;
    }();
    return names;
}

std::optional<Rgba> colour_of(const Arguments& args, Warnings& warnings) {
    Rgba out{0, 0, 0, 1};
    if (!args.has("c")) return std::nullopt;
    if (args.is("c", ValueKind::text)) {
        const std::string name = args.text("c");
        const auto found = parse_colour(name);
        if (!found) {
            warnings.add(args.where(),
                         "no colour \"" + name.substr(0, 40) + "\"" + did_you_mean(name, colour_names()) + ": ignored");
            return std::nullopt;
        }
        out = *found;
    } else {
        const auto xs = *args.numbers("c", 0);
        for (std::size_t i = 0; i < std::min<std::size_t>(xs.size(), 4); ++i) out[i] = xs[i];
        if (out[0] == -1 && out[1] == -1 && out[2] == -1) return std::nullopt;
    }
    out[3] = args.number("alpha", out[3]);
    for (double& x : out) {
        if (!std::isfinite(x)) args.fail("found a colour that is not finite, wanted numbers from 0 to 1");
        x = std::clamp(x, 0.0, 1.0);
    }
    return out;
}

Rgb linear_colour(const Rgba& c) { return {linear(c[0]), linear(c[1]), linear(c[2])}; }

}  // namespace cardioid::formats::openscad

#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "formats/openscad/evaluate/arguments.hpp"
#include "rt_core/math/rgb.hpp"

namespace cardioid::formats::openscad {

/// Red, green, blue as sRGB display values and opacity, each within [0, 1].
using Rgba = std::array<double, 4>;

/// A CSS colour name (case does not count) or "#rgb", "#rgba", "#rrggbb", "#rrggbbaa"; nothing where it is neither.
std::optional<Rgba> parse_colour(std::string_view text);

/// Every colour name.
std::span<const std::string_view> colour_names();

/// The colour of color(c, alpha), clamped; nothing for "no colour" ([-1, -1, -1, a], undef, an unknown name, which
/// is a warning).
std::optional<Rgba> colour_of(const Arguments& arguments, Warnings& warnings);

/// OpenSCAD's colours are display values (sRGB, IEC 61966-2-1); light is reckoned with in linear Rec.709.
Rgb linear_colour(const Rgba& colour);

}  // namespace cardioid::formats::openscad

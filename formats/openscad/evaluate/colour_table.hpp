#pragma once
#include <cstdint>
#include <span>

namespace cardioid::formats::openscad {

struct NamedColour {
    const char* name;   ///< lower case
    std::uint32_t rgb;  ///< 0xRRGGBB
};

/// The colour names of CSS Color Module Level 4, which OpenSCAD takes too.
std::span<const NamedColour> colour_table();

}  // namespace cardioid::formats::openscad

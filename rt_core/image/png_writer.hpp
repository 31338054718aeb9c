#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace cardioid {

/// A PNG file (ISO/IEC 15948) of 8-bit sRGB values, three a pixel; the description is a text of it, "" for none.
std::vector<std::uint8_t> encode_png(int width, int height, const std::vector<std::uint8_t>& rgb,
                                     const std::string& description);

}  // namespace cardioid

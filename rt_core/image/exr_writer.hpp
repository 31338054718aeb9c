#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "rt_core/api/image.hpp"

namespace cardioid {

/// A channel of an OpenEXR file: its values are first[0], first[stride], ... of every pixel, rows from the top.
struct ExrChannel {
    std::string name;
    bool half;  ///< 16 bits, else 32
    const float* first;
    std::size_t stride;
};

/// An OpenEXR file (version 2, lines of pixels, ZIP) with its metadata as attributes. Any order of channels; at least
/// one, each with width * height values.
std::vector<std::uint8_t> encode_exr(int width, int height, std::vector<ExrChannel> channels, const Metadata& metadata);

}  // namespace cardioid

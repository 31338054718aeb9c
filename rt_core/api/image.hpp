#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace cardioid {

/// Name and text of a metadata entry: program version, command line, seed, scene hash ...
using Metadata = std::vector<std::pair<std::string, std::string>>;

/// The first picture of a file, its channels side by side, rows from the top.
struct RawImage {
    int width = 0, height = 0;
    std::vector<std::string> channels;  ///< their names
    bool encoded = false;               ///< sRGB values of 8 or 16 bits, 0 to 1 here; else light
    std::vector<float> values;
    std::vector<bool> half;  ///< for writing: which channels take 16 bits where the format can; empty: none
    Metadata metadata;
};

/// Any file OpenImageIO reads. Throws Error(io), Error(limit) where it has more pixels.
RawImage read_raw_image(const std::string& path, std::int64_t most_pixels);

}  // namespace cardioid

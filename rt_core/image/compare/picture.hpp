#pragma once
#include <string>
#include <vector>

#include "rt_core/image/film.hpp"

namespace cardioid {

/// A picture as comparing sees it: linear Rec.709, whatever its file is.
struct Picture {
    std::string path;
    int width = 0, height = 0;
    int channels = 0;           ///< of the file's picture: 1 grey, 3 colour, 2 and 4 the same with alpha
    bool encoded = false;       ///< the file holds sRGB values of 8 or 16 bits, which are decoded here
    std::vector<Rgb> pixels;    ///< grey is the same in all channels
    std::vector<float> alpha;   ///< empty without
    std::vector<Layer> layers;  ///< what else the file holds

    [[nodiscard]] const Layer* layer(const std::string& name) const {
        for (const Layer& l : layers)
            if (l.name == name) return &l;
        return nullptr;
    }
};

/// Any file OpenImageIO reads. Throws Error(io) where it cannot be read, Error(bad_input) where it has no picture of
/// one to four channels.
Picture read_picture(const std::string& path);

}  // namespace cardioid

#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "rt_core/math/rgb.hpp"

namespace cardioid {

/// A picture layer: `channels` floats a pixel, rows from the top.
struct Layer {
    std::string name;  ///< "" for the beauty picture, else "direct", "normal", ...
    int channels = 3;
    std::vector<float> pixels;
};

/// Linear float layers of one size. The first layer is the beauty picture in linear Rec.709 radiance.
struct Film {
    int width = 0, height = 0;
    std::vector<Layer> layers;

    /// The layer of that name, or null.
    [[nodiscard]] const Layer* layer(const std::string& name) const {
        for (const Layer& l : layers)
            if (l.name == name) return &l;
        return nullptr;
    }
};

}  // namespace cardioid

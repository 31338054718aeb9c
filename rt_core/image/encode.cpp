#include "rt_core/image/encode.hpp"

#include <algorithm>
#include <cmath>

#include "rt_core/math/sampler.hpp"

namespace cardioid {

namespace {

/// Comparisons are written so that NaN becomes 0.
std::uint8_t quantised(float x) {
    return static_cast<std::uint8_t>(std::lround((x > 0 ? std::min(x, 1.0F) : 0) * 255));
}

float largest_finite(const std::vector<float>& values) {
    float most = 0;
    for (const float v : values)
        if (std::isfinite(v)) most = std::max(most, v);
    return most;
}

}  // namespace

float srgb_encode(float linear) {
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

float srgb_decode(float encoded) {
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

std::vector<std::uint8_t> encode_8bit(const Layer& layer, double exposure) {
    const auto channels = static_cast<std::size_t>(layer.channels);
    const std::size_t n = layer.pixels.size() / channels;
    const float gain = static_cast<float>(std::exp2(exposure));
    const float deepest = layer.name == "depth" ? largest_finite(layer.pixels) : 1;
    std::vector<std::uint8_t> out(n * 3);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const float x = layer.pixels[i * channels + std::min(c, channels - 1)];
            float shown = 0;
            if (layer.name == "normal")
                shown = (x + 1) / 2;
            else if (layer.name == "depth")
                shown = deepest > 0 ? x / deepest : 0;
            else if (layer.name == "region")
                shown = x < 0 ? 0 : static_cast<float>(mix64(static_cast<std::uint64_t>(x)) >> (8 * c) & 255) / 255;
            else
                shown = x > 0 ? srgb_encode(std::min(x * gain, 1.0F)) : 0;
            out[i * 3 + c] = quantised(shown);
        }
    return out;
}

}  // namespace cardioid

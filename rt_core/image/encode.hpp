#pragma once
#include <cstdint>
#include <vector>

#include "rt_core/image/film.hpp"

namespace cardioid {

/// The sRGB curve, linear [0, 1] to encoded [0, 1] (IEC 61966-2-1).
float srgb_encode(float linear);
float srgb_decode(float encoded);

/// A layer as 8-bit RGB, rounded to the nearest value; NaN is black. Light is scaled by 2^exposure and sRGB-encoded;
/// "normal" shows (n + 1) / 2, "depth" its share of the largest, "region" a colour for each id, none of them encoded.
std::vector<std::uint8_t> encode_8bit(const Layer& layer, double exposure);

}  // namespace cardioid

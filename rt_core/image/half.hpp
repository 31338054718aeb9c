#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace cardioid {

/// IEEE 754 binary16, rounded to nearest even; what is too large is the largest there is, but infinity stays infinite.
inline std::uint16_t to_half(float x) noexcept {
    constexpr float largest = 65504, smallest_normal = 0x1p-14F;
    if (!std::isfinite(x)) return std::isnan(x) ? 0x7E00 : x > 0 ? 0x7C00 : 0xFC00;
    const std::uint16_t sign = std::signbit(x) ? 0x8000 : 0;
    const float size = std::min(std::abs(x), largest);
    if (size < smallest_normal) return static_cast<std::uint16_t>(sign | std::lrint(size * 0x1p24F));
    const auto bits = std::bit_cast<std::uint32_t>(size);
    const std::uint32_t rounded = bits + 0xFFF + (bits >> 13 & 1);
    return static_cast<std::uint16_t>(sign | ((rounded >> 13) - (112U << 10)));
}

}  // namespace cardioid

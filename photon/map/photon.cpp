#include "photon/map/photon.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace cardioid::photon {

namespace {

constexpr float steps = 65534;  ///< even, so that 0 is a step and axes are exact

/// -1 or 1, never 0.
float sign(float x) { return x < 0 ? -1.0F : 1.0F; }

std::uint32_t to_steps(float x) {
    return static_cast<std::uint32_t>((x * 0.5F + 0.5F) * steps + 0.5F);  // NOLINT(bugprone-incorrect-roundings): > 0
}
float from_steps(std::uint32_t bits) { return static_cast<float>(bits) * (2 / steps) - 1; }

/// Values have 9 bits below 2^(exponent - bias - 9).
constexpr int bias = 15, mantissa_bits = 9, top_exponent = 31, float_bias = 127;

}  // namespace

std::uint32_t encode_direction(Vec3 unit) noexcept {
    const float sum = std::abs(unit.x) + std::abs(unit.y) + std::abs(unit.z);
    float u = unit.x / sum, v = unit.y / sum;
    if (unit.z < 0) {
        const float folded = (1 - std::abs(v)) * sign(u);
        v = (1 - std::abs(u)) * sign(v);
        u = folded;
    }
    return to_steps(u) | to_steps(v) << 16;
}

Vec3 decode_direction(std::uint32_t bits) noexcept {
    float u = from_steps(bits & 0xFFFFU), v = from_steps(bits >> 16);
    const float z = 1 - std::abs(u) - std::abs(v);
    if (z < 0) {
        const float unfolded = (1 - std::abs(v)) * sign(u);
        v = (1 - std::abs(u)) * sign(v);
        u = unfolded;
    }
    return normalize(Vec3{u, v, z});
}

std::uint32_t encode_flux(Rgb flux, float scale, float dither) noexcept {
    const Rgb c = flux * (1 / scale);
    const float largest = max_component(c);
    if (!(largest > 0)) return 0;
    // The exponent that puts the largest, rounded either way, below 2^9 steps; taken from the bits of the float, for
    // photons are stored by the million.
    constexpr float most_steps = 511;
    const int power = static_cast<int>(std::bit_cast<std::uint32_t>(largest) >> 23) - float_bias;
    int exponent = std::clamp(power + 1 + bias, 0, top_exponent);
    const auto steps_of = [&](float x) {
        const int shift = mantissa_bits + bias - exponent + float_bias;
        return x * std::bit_cast<float>(static_cast<std::uint32_t>(shift) << 23);
    };
    if (steps_of(largest) > most_steps && exponent < top_exponent) ++exponent;
    const auto channel = [&](float x) {
        return static_cast<std::uint32_t>(std::min(steps_of(x), most_steps) + dither);
    };
    return channel(c.r) | channel(c.g) << 9 | channel(c.b) << 18 | static_cast<std::uint32_t>(exponent) << 27;
}

float flux_dither(Vec3 p) noexcept {
    const auto bits = [](float x) { return std::uint64_t{std::bit_cast<std::uint32_t>(x)}; };
    const std::uint64_t hash = mix64(mix64(bits(p.x) << 32 | bits(p.y)) ^ bits(p.z));
    constexpr int digits = 23;  // one less than a float has: 511 and this stay below 512
    return static_cast<float>(hash >> (64 - digits)) * 0x1p-23F * (1 - 0x1p-14F);
}

}  // namespace cardioid::photon

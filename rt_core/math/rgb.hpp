#pragma once
#include <algorithm>
#include <cmath>

namespace cardioid {

/// A quantity per channel of linear Rec.709: reflectance, radiance, flux. Never a display value.
struct Rgb {
    float r = 0, g = 0, b = 0;
    constexpr Rgb() = default;
    constexpr explicit Rgb(float grey) : r(grey), g(grey), b(grey) {}
    constexpr Rgb(float r_, float g_, float b_) : r(r_), g(g_), b(b_) {}
    constexpr bool operator==(const Rgb&) const = default;
    constexpr Rgb& operator+=(Rgb o) { return *this = *this + o; }
    constexpr Rgb& operator*=(Rgb o) { return *this = *this * o; }
    constexpr Rgb& operator*=(float s) { return *this = *this * s; }
    friend constexpr Rgb operator+(Rgb a, Rgb c) { return {a.r + c.r, a.g + c.g, a.b + c.b}; }
    friend constexpr Rgb operator-(Rgb a, Rgb c) { return {a.r - c.r, a.g - c.g, a.b - c.b}; }
    friend constexpr Rgb operator*(Rgb a, Rgb c) { return {a.r * c.r, a.g * c.g, a.b * c.b}; }
    friend constexpr Rgb operator*(Rgb a, float s) { return {a.r * s, a.g * s, a.b * s}; }
    friend constexpr Rgb operator*(float s, Rgb a) { return a * s; }
    friend constexpr Rgb operator/(Rgb a, float s) { return {a.r / s, a.g / s, a.b / s}; }
};

constexpr float max_component(Rgb c) { return std::max(c.r, std::max(c.g, c.b)); }
constexpr float min_component(Rgb c) { return std::min(c.r, std::min(c.g, c.b)); }
/// Rec.709 luminance of a linear colour (ITU-R BT.709-6, 3.2).
constexpr float luminance(Rgb c) { return 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b; }
constexpr bool is_black(Rgb c) { return c.r == 0 && c.g == 0 && c.b == 0; }
inline bool is_finite(Rgb c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }
/// exp(c) channel by channel; Beer-Lambert transmittance is exp(-absorption * distance).
inline Rgb exp(Rgb c) { return {std::exp(c.r), std::exp(c.g), std::exp(c.b)}; }

}  // namespace cardioid

#pragma once
#include <bit>
#include <cstdint>

#include "rt_core/api/math.hpp"

namespace cardioid::photon {

/// How a photon came to its surface, a set of bits (ARL-TR-3608, equation 1, by the paths of its terms).
enum class Way : std::uint8_t {
    direct = 0,    ///< straight from the lamp
    specular = 1,  ///< met mirrors or glass
    glossy = 2,    ///< met a lobe of finite width
    diffuse = 4,   ///< met a diffuse surface
    broad = 8,     ///< met a lobe of finite width that is_broad()
};
constexpr Way operator|(Way a, Way b) { return static_cast<Way>(static_cast<int>(a) | static_cast<int>(b)); }
constexpr bool has(Way set, Way bit) { return (static_cast<int>(set) & static_cast<int>(bit)) != 0; }

/// From how many directions its light comes to a place: a solid angle, encode_breadth().
enum class Breadth : std::uint8_t { none = 0 };

/// A unit vector in 32 bits: octahedral, 16 bits a coordinate, rounded; mean error 0.0013 degrees.
/// (Meyer et al. 2010, "On floating-point normal vectors".)
[[nodiscard]] std::uint32_t encode_direction(Vec3 unit) noexcept;
[[nodiscard]] Vec3 decode_direction(std::uint32_t bits) noexcept;

/// Three floats >= 0 with one 5-bit exponent and 9 bits each (the shared-exponent format of OpenGL 3.0); the exponent
/// is offset by `scale` 2^n, so that fluxes of any unit fit: values are stored divided by it. Each is rounded up where
/// its rest is at least 1 - `dither`, in [0, 1): one half rounds to the nearest, evenly spread ones keep the mean of
/// many.
[[nodiscard]] std::uint32_t encode_flux(Rgb flux, float scale, float dither = 0.5F) noexcept;
/// The dither of the photon at p: all that leave a lamp have the same flux and would share the error of its rounding,
/// up to 1/512 of the largest channel.
[[nodiscard]] float flux_dither(Vec3 p) noexcept;
[[nodiscard]] inline Rgb decode_flux(std::uint32_t bits, float scale) noexcept {
    constexpr std::uint32_t float_bias = 127, bias = 15, mantissa_bits = 9;
    const float step = scale * std::bit_cast<float>(((bits >> 27) + (float_bias - bias - mantissa_bits)) << 23);
    const auto channel = [step](std::uint32_t b) { return static_cast<float>(b & 511U) * step; };
    return {channel(bits), channel(bits >> 9), channel(bits >> 18)};
}

/// Light that met a surface. 32 bytes (ARL-TR-3608, note [4], with what the note leaves out: where the light came from
/// and on which surface it fell).
struct Photon {
    Vec3 p;                ///< relative to the origin of its map, scene units
    std::uint32_t flux;    ///< encode_flux [W]
    std::uint32_t wi;      ///< encode_direction: to where it came from
    std::uint32_t n;       ///< encode_direction: geometric normal on the side that it fell on
    std::uint32_t region;  ///< SurfacePoint::id.region
    Way way;
    Breadth breadth;     ///< of photons of mirrors, glass and glossy lobes alone
    std::uint16_t time;  ///< within the shutter, 0 to 65535
};
static_assert(sizeof(Photon) == 32);

/// A photon without its place, which PointTree keeps apart.
struct PhotonPayload {
    std::uint32_t flux, wi;
    Way way;
    Breadth breadth;
    std::uint16_t time;
};
[[nodiscard]] constexpr PhotonPayload payload_of(const Photon& photon) noexcept {
    return {photon.flux, photon.wi, photon.way, photon.breadth, photon.time};
}

}  // namespace cardioid::photon

#pragma once
#include <cstdint>

namespace cardioid::photon {

/// Which preset the options begin with; every item of it can be set by itself afterwards.
enum class Mode : std::uint8_t {
    physical,  ///< right, without bias where it can be had
    report,    ///< as ARL-TR-3608 has it, pitfalls included
};

/// How the directions of emitted photons are drawn.
enum class Directions : std::uint8_t {
    closed,  ///< by the light's own closed form, in low-discrepancy order
    ball,    ///< by rejection from a ball (ARL-TR-3608, section 3.1), independently
};

/// How photons are shared out among lights.
enum class Shares : std::uint8_t {
    power,  ///< in proportion to power, so that all photons carry about the same flux
    even,   ///< as many for each light
};

/// What Russian roulette compares.
enum class Roulette : std::uint8_t {
    flux,  ///< P = max_c(rho_c Phi_c) / max_c Phi_c, no channel ever grows (Jensen 2001, section 5.2.3)
    mean,  ///< P = the mean of rho over the channels (ARL-TR-3608, equations 2 to 4)
};

/// Which photons are kept.
enum class Store : std::uint8_t {
    all,       ///< at every surface that scatters
    absorbed,  ///< where they end only
};

/// Weight of a photon at distance d = t r of a lookup of radius r; each integrates to 1 over the disc.
enum class Kernel : std::uint8_t {
    box,           ///< 1 / (pi r^2)
    cone,          ///< (1 - t) 3 / (pi r^2)
    gauss,         ///< of ARL-TR-3608, with the constant that makes it integrate to 1
    epanechnikov,  ///< (1 - t^2) 2 / (pi r^2)
    biweight,      ///< (1 - t^2)^2 3 / (pi r^2)
};

/// What is done where part of a lookup's disc is not on the surface (ARL-TR-3608, note [8]).
enum class EdgeRule : std::uint8_t {
    none,
    report,  ///< divide by the share of photons that passed the normal test
    hull,    ///< divide by the area of the photons' convex hull
    probe,   ///< divide by the area that short rays find
};

/// Where indirect light comes from.
enum class Indirect : std::uint8_t {
    cache,        ///< an irradiance cache filled on demand
    precomputed,  ///< irradiance at every n-th photon, the mean of the nearest (ARL-TR-3608, note [6])
    gather,       ///< a final gather at every point
    map,          ///< the photon map itself
    none,
};

/// How a hemisphere is divided (ARL-TR-3608, note [7]).
enum class Strata : std::uint8_t {
    cosine,       ///< cells of equal projected solid angle: the plain mean is right
    solid_angle,  ///< cells of equal solid angle
    angle,        ///< cells of equal angles
};

}  // namespace cardioid::photon

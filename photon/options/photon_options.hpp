#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "photon/options/choices.hpp"
#include "rt_core/api/params.hpp"

namespace cardioid::photon {

/// Every switch of the photon module, read once. What is not set here is derived from the scene (heuristics/).
/// Defaults are those of `mode = physical`.
struct PhotonOptions {
    Mode mode = Mode::physical;

    // How many photons, from what accuracy (ARL-TR-3608, note [1]).
    std::optional<std::uint64_t> count;          ///< emitted for the global map
    std::optional<std::uint64_t> caustic_count;  ///< emitted for the caustic map
    bool count_by_faces = false;                 ///< the report's rule: 10,000 and one for every 100 triangles
    double error = 0.05;                         ///< wanted relative standard error of a lookup, in (0, 1]
    std::optional<double> memory;                ///< most bytes that photons may take; nothing: a share of RAM

    // Emission and propagation (report, section 3).
    Directions directions = Directions::closed;
    Shares shares = Shares::power;
    Roulette roulette = Roulette::flux;
    bool rr_double_count = false;  ///< reflectance thins the photons and scales their flux too
    Store store = Store::all;
    bool aim_caustics = true;  ///< caustic photons are sent where mirrors and glass are

    // Lookups in the maps (sections 3.3 and 6.2).
    std::optional<std::uint32_t> k;          ///< photons of a lookup
    std::optional<double> radius;            ///< largest radius of a lookup, scene units
    std::optional<std::uint32_t> caustic_k;  ///< the same of the caustic map
    std::optional<double> caustic_radius;
    Kernel kernel = Kernel::epanechnikov;
    Kernel caustic_kernel = Kernel::cone;
    bool fixed_radius = false;     ///< every lookup takes `radius` whole, whatever it finds
    bool count_last = false;       ///< the photon that sets the radius counts too, which is too bright by 1/(k - 1)
    double normal_tolerance = 60;  ///< degrees between a photon's normal and the surface's
    EdgeRule edge = EdgeRule::probe;

    // Indirect light (section 5).
    Indirect indirect = Indirect::cache;
    std::array<int, 2> hemisphere{0, 0};  ///< rows and columns of gather rays; 0: as many as the error asks for
    Strata strata = Strata::cosine;
    bool half_jitter = false;                   ///< rays keep to the first half of their cells, as the report has them
    int cache_every = 4;                        ///< precomputed: irradiance at every n-th photon
    int cache_nearest = 1;                      ///< precomputed: so many cache points are averaged; the report: 50
    std::optional<double> cache_error;          ///< a of equation 5: how far a cache point reaches
    std::array<double, 2> cache_pixels{3, 30};  ///< least and most that a cache point reaches, pixels
    bool cache_edge = false;                    ///< the report's edge rule divides cache lookups too
    bool keep_map = false;                      ///< the global map stays once the cache stands

    std::optional<std::array<double, 2>> view_pixel;  ///< whose lookup and gather are shown; nothing: in the middle
};

/// The table that `cardioid list` prints.
[[nodiscard]] std::span<const ParamSpec> photon_params();

/// Reads the scene's photons(...) and --set photon.*; names it does not know it leaves to the caller. Throws
/// Error(bad_input) with the place where a type is wrong or a value out of its range.
[[nodiscard]] PhotonOptions read_photon_options(const Params& params);

}  // namespace cardioid::photon

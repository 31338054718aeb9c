#include "photon/options/photon_options.hpp"

namespace cardioid::photon {

namespace {

constexpr ParamSpec params[] = {
    {"mode", ParamType::text, "physical", "physical, or report: the preset that shows what ARL-TR-3608 describes"},

    {"count", ParamType::number, "automatic", "photons emitted for the global map, 1 to 4e9 a light"},
    {"caustic_count", ParamType::number, "automatic", "photons emitted for the caustic map, 0: no such map"},
    {"count_by_faces", ParamType::boolean, "false", "the report's rule: 10,000 photons and one for every 100 faces"},
    {"error", ParamType::number, "0.05", "wanted relative standard error of a lookup, 0.001 to 1"},
    {"memory", ParamType::number, "half of RAM", "most megabytes that photons may take"},

    {"directions", ParamType::text, "closed", "how photons leave a light: closed or ball (rejection)"},
    {"shares", ParamType::text, "power", "photons of a light: in proportion to its power, or even"},
    {"roulette", ParamType::text, "flux", "chance to go on: by flux (per channel) or mean reflectance"},
    {"rr_double_count", ParamType::boolean, "false", "reflectance scales the flux of survivors too (wrong: too dark)"},
    {"store", ParamType::text, "all", "photons kept: all that hit, or absorbed: where they end"},
    {"aim_caustics", ParamType::boolean, "true", "caustic photons are sent to where mirrors and glass are"},

    {"k", ParamType::number, "automatic", "photons of a lookup in the global map, 2 to 10000"},
    {"radius", ParamType::number, "automatic", "largest radius of a lookup [scene units]"},
    {"caustic_k", ParamType::number, "automatic", "photons of a lookup in the caustic map, 2 to 10000"},
    {"caustic_radius", ParamType::number, "automatic", "largest radius of a lookup in the caustic map [scene units]"},
    {"kernel", ParamType::text, "epanechnikov", "weights of a lookup: box, cone, gauss, epanechnikov or biweight"},
    {"caustic_kernel", ParamType::text, "cone", "the same of the caustic map"},
    {"fixed_radius", ParamType::boolean, "false", "every lookup has the whole radius, however many photons it finds"},
    {"count_last", ParamType::boolean, "false", "the photon that sets the radius counts too (1/(k-1) too bright)"},
    {"normal_tolerance", ParamType::number, "60", "most degrees between normals of photon and surface, 0 to 90"},
    {"edge", ParamType::text, "probe", "lookups across an edge: none, report, hull or probe"},

    {"indirect", ParamType::text, "cache", "cache, precomputed (every n-th photon), gather, map or none"},
    {"hemisphere", ParamType::vector, "automatic", "[rows, columns] of the rays of a gather"},
    {"strata", ParamType::text, "cosine", "cells of a hemisphere: cosine, solid_angle or angle"},
    {"half_jitter", ParamType::boolean, "false",
     "gather rays keep to the first half of their cells (too dark or bright)"},
    {"cache_every", ParamType::number, "4", "precomputed: irradiance at every n-th photon, 1 to 1000"},
    {"cache_nearest", ParamType::number, "1", "precomputed: mean of so many cache points, 1 to 1000"},
    {"cache_error", ParamType::number, "automatic", "error that a cache point may make, 0.01 to 1: equation 5's a"},
    {"cache_pixels", ParamType::vector, "[3, 30]", "[least, most] that a cache point reaches [pixels]"},
    {"cache_edge", ParamType::boolean, "false", "the report's edge rule for cache lookups too (wrong: too bright)"},
    {"keep_map", ParamType::boolean, "false", "the global map stays in memory once the cache stands"},
    {"view_pixel", ParamType::vector, "the middle", "[x, y] of what --view lookup and --view gather show [pixels]"},
};

}  // namespace

std::span<const ParamSpec> photon_params() { return params; }

}  // namespace cardioid::photon

#include "photon/lighting/tuning.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace cardioid::photon {

namespace {

/// What these make of an error of 5 % was measured on the canonical Cornell boxes: indirect light is right to 0.5 % of
/// the picture. Stratified rays err as n^-3/4 where light changes smoothly, a cache with gradients as the square of
/// its reach.
constexpr double usual_error = 0.05;
constexpr double usual_rays = 576, fewest_rays = 256, most_rays = 10'000;
constexpr double usual_reach = 0.25, least_reach = 0.05, most_reach = 0.5;

/// Points of the caustic cache reach this share of the radius that their photons came from: within that a density
/// estimate hardly changes.
constexpr float caustic_reach = 0.8F;
/// And at least so many pixels; what lies between is looked up in the map. A whole pixel blurs the edges of caustics.
constexpr float caustic_pixels = 0.3F;

/// Places that radiance photons are made of: what pictures of 200,000 pixels get, and fewer for small or rough ones.
constexpr double most_places = 50'000, fewest_places = 12'000, usual_pixels = 200'000;

double places_for(const Eye* eye, double strictness) {
    if (!eye) return most_places;
    const double pixels = static_cast<double>(eye->width()) * eye->height();
    const double places = most_places * std::sqrt(strictness * std::sqrt(pixels / usual_pixels));
    return std::clamp(places, fewest_places, most_places);
}

HemisphereCells cells_of(Strata strata) {
    switch (strata) {
        case Strata::cosine:
            return HemisphereCells::cosine;
        case Strata::solid_angle:
            return HemisphereCells::equal_solid_angle;
        case Strata::angle:
            return HemisphereCells::equal_angle;
    }
    return HemisphereCells::cosine;
}

}  // namespace

Tuning tune(const PhotonOptions& options, const Eye* eye, std::uint32_t seed) {
    Tuning tuning;
    const double strictness = usual_error / options.error;
    const std::string why = fmt::format("for photon.error {:g}", options.error);
    const double rays = std::clamp(usual_rays * std::pow(strictness, 4.0 / 3), fewest_rays, most_rays);
    tuning.hemisphere = Hemisphere::of(static_cast<int>(std::lround(rays)));
    if (options.hemisphere[0] > 0)
        tuning.hemisphere.rings = options.hemisphere[0], tuning.hemisphere.sectors = options.hemisphere[1];
    else
        tuning.derived.push_back(
            {"hemisphere", fmt::format("{} x {}", tuning.hemisphere.rings, tuning.hemisphere.sectors), why});
    tuning.hemisphere.cells = cells_of(options.strata);
    tuning.hemisphere.jitter = options.half_jitter ? 0.5F : 1.0F;

    const double reach = std::clamp(usual_reach / std::sqrt(strictness), least_reach, most_reach);
    tuning.indirect_rules.reach = static_cast<float>(options.cache_error.value_or(reach));
    if (!options.cache_error) tuning.derived.push_back({"cache_error", fmt::format("{:.3g}", reach), why});
    tuning.indirect_rules.least_pixels = static_cast<float>(options.cache_pixels[0]);
    tuning.indirect_rules.most_pixels = static_cast<float>(options.cache_pixels[1]);
    tuning.caustic_rules = {.reach = caustic_reach, .least_pixels = caustic_pixels, .most_pixels = 20};
    tuning.overture = {.seed = seed};
    tuning.radiance_photons = static_cast<std::uint64_t>(places_for(eye, strictness));
    tuning.light_rays = 16;
    return tuning;
}

}  // namespace cardioid::photon

#pragma once
#include <optional>

#include "photon/lighting/light_maps.hpp"

namespace cardioid::photon {

/// What is kept of light at the places that the eye sees.
struct EyeCaches {
    std::optional<IrradianceCache> indirect;
    std::optional<IrradianceCache> caustic;  ///< for surfaces that are diffuse alone
};

/// Fills the caches that the options and maps ask for. Stops early when interrupted.
[[nodiscard]] EyeCaches fill_eye_caches(const World& world, const Eye& eye, const PhotonOptions& options,
                                        const LightMaps& maps, const IncomingLight& incoming, const Tuning& tuning,
                                        std::uint32_t seed, Progress& progress);

}  // namespace cardioid::photon

#pragma once
#include <string>

#include "photon/options/photon_options.hpp"

namespace cardioid::photon {

/// The options that decide what a saved map holds, as lines of "option = value": photons, and the cache made of them.
/// What only lookups while rendering read is not among them, so that it may change between saving and loading.
[[nodiscard]] std::string shape_text(const PhotonOptions& options, std::uint32_t seed);

}  // namespace cardioid::photon

#include "photon/lighting/photon_lighting.hpp"

#include "photon/lighting/photon_module.hpp"

namespace cardioid::photon {

namespace {

std::unique_ptr<LightingModule> make(const Params& params, std::uint32_t seed) {
    return std::make_unique<PhotonModule>(read_photon_options(params), seed);
}

}  // namespace

const LightingKind photon_lighting{"photon", "photon mapping: all light between surfaces, and caustics",
                                   photon_params(), make};

}  // namespace cardioid::photon

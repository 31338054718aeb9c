#pragma once
#include "photon/emission/aim.hpp"
#include "photon/emission/light_shares.hpp"
#include "photon/map/tree/untouched.hpp"
#include "photon/propagation/photon_path.hpp"
#include "rt_core/api/progress.hpp"

namespace cardioid::photon {

/// One pass over all lights.
struct ShotRequest {
    std::uint32_t seed = 0;
    Pass pass = Pass::global;
    Keep keep = Keep::everything;
    std::uint64_t count = 0;   ///< photons to emit
    const Aim* aim = nullptr;  ///< where they are sent; null or no cells: evenly over what lights emit
    PathClasses unwanted{};    ///< counted in the ledger, not brought home
};

/// What a pass brought home. The same bits for any number of threads.
struct Shot {
    UntouchedVector<Photon> photons;  ///< by light, then by number
    Vec3d origin;                     ///< photon positions are relative to it, scene units
    float flux_scale = 1;             ///< of decode_flux
    std::uint64_t emitted = 0;        ///< photons asked of the lights
    Rgb power;                        ///< sum of Light::power() [W], to compare with ledger.emitted
    Ledger ledger;
};

/// Emits photons in chunks on all threads and follows them. Throws Error(limit) where one light has too many photons.
/// Reports progress within the current phase; once Progress::interrupted() the shot is incomplete and of no use.
[[nodiscard]] Shot shoot(const World& world, const PhotonOptions& options, const ShotRequest& request,
                         Progress& progress);

}  // namespace cardioid::photon

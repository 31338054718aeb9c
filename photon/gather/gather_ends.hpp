#pragma once
#include <vector>

#include "photon/map/photon.hpp"
#include "rt_core/api/eye.hpp"
#include "rt_core/api/world.hpp"

namespace cardioid::photon {

/// Places where the rays of final gathers end, for the picture that the eye is about to take: as many on a surface as
/// rays will ask there, however little light it has. As photons without flux: `wi` is where the ray came from,
/// positions are relative to `origin`. At most `count`, fewer where rays mostly leave the scene; the same for any
/// number of threads.
[[nodiscard]] std::vector<Photon> gather_ends(const World& world, const Eye& eye, std::uint32_t seed, std::size_t count,
                                              Vec3d origin);

}  // namespace cardioid::photon

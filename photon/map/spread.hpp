#pragma once
#include "photon/map/photon_map.hpp"

namespace cardioid::photon {

/// Gives the photons of a map discs of their own to light, as large as `rule.k` of them lie around, but no larger than
/// rule.max_radius (finite or not), and smaller where there are smaller ones near by.
///
/// Light is then the sum of what the discs bring, whose flux is that of the photons whatever their sizes: sizes that
/// follow the noise of the photons move light a little, but make none. A disc that is chosen where light is looked up
/// makes some: it stops growing, or does not, where there is more light by chance. Discs of which each holds as many
/// photons (their area is inverse to the density) have a bias of the order of the radius to the fourth in place of
/// its square (Abramson 1982, "On bandwidth variation in kernel estimates"). Photons near each other, to a sixteenth
/// of k of them, share a size. The same for any number of threads.
[[nodiscard]] KdReach spread_photons(const PhotonMap& map, const LookupRule& rule);

}  // namespace cardioid::photon
